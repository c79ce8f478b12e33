/* SPDX-License-Identifier: MIT
 *
 * The axes of the camera and its rays.
 */
#include "view/camera.h"

#include "shared/sine.h"

struct vector direction_of(double azimuth, double elevation)
{
    const double across = sine(elevation + 90.0);
    return (struct vector){(float)(sine(azimuth) * across), (float)(sine(azimuth + 90.0) * across),
                           (float)sine(elevation < 0.0 ? elevation + 360.0 : elevation)};
}

void camera_turn(struct camera *camera, double azimuth, double elevation, double fov)
{
    const float reach = (float)(sine(fov * 0.5) / sine(fov * 0.5 + 90.0));
    const float ratio = (float)camera->height / (float)camera->width;
    const struct vector right =
        direction_of(azimuth <= 270.0 ? azimuth + 90.0 : azimuth - 270.0, 0);
    const struct vector forward = direction_of(azimuth, elevation);
    const struct vector up = {right.y * forward.z - right.z * forward.y,
                              right.z * forward.x - right.x * forward.z,
                              right.x * forward.y - right.y * forward.x};
    camera->forward = forward;
    camera->right = scaled(right, reach);
    camera->up = scaled(up, reach * ratio);
    camera->pixel = 2.0f * reach / (float)camera->width;
}

struct vector camera_ray(const struct camera *camera, float column, float row)
{
    const float u = 2.0f * column / (float)camera->width - 1.0f;
    const float v = 1.0f - 2.0f * row / (float)camera->height;
    return unit((struct vector){camera->forward.x + u * camera->right.x + v * camera->up.x,
                                camera->forward.y + u * camera->right.y + v * camera->up.y,
                                camera->forward.z + u * camera->right.z + v * camera->up.z});
}
