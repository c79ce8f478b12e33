/* SPDX-License-Identifier: MIT
 *
 * Where the camera is and looks by default.
 */
#ifndef SCARP_CLI_VIEW_VIEWPOINT_H
#define SCARP_CLI_VIEW_VIEWPOINT_H

#include "view/scene.h"
#include "view/view_options.h"

/* Completes `camera` and `look` of the options where they are not given. The scene has its ground
   and its sun. */
void viewpoint_choose(struct view_options *options, const struct scene *scene);

#endif
