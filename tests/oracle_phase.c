/* SPDX-License-Identifier: MIT
 *
 * How the gradients of flow noise turn, as scarp.h defines it ("Flow").
 */
#include "oracle.h"

#include <math.h>

#define TURN (2.0 * 3.14159265358979323846)

void oracle_turn_in_plane(double still, double speed, double turns, double vector[3],
                          double derivative[3])
{
    const double angle = still + speed * TURN * turns;
    vector[0] = cos(angle);
    vector[1] = sin(angle);
    vector[2] = 0.0;
    derivative[0] = -speed * TURN * sin(angle);
    derivative[1] = speed * TURN * cos(angle);
    derivative[2] = 0.0;
}

void oracle_turn_about(const double axis[3], const double still[3], double speed, double turns,
                       double vector[3], double derivative[3])
{
    const double angle = speed * TURN * turns;
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        const double quarter = axis[j] * still[k] - axis[k] * still[j];
        vector[i] = cos(angle) * still[i] + sin(angle) * quarter;
        derivative[i] = speed * TURN * (cos(angle) * quarter - sin(angle) * still[i]);
    }
}

/* Directions at 11.25 degrees + k * 45 turn left, the others right, twice as fast. */
static void turn_in_plane(unsigned index, double turns, double vector[3], double derivative[3])
{
    oracle_gradient_vector(2, index, vector);
    const double still = atan2(vector[1], vector[0]);
    const double eighths = (still - TURN / 32.0) / (TURN / 8.0); /* of a turn, from 11.25 on */
    const double speed = fabs(eighths - round(eighths)) < 0.25 ? 1.0 : -2.0;
    oracle_turn_in_plane(still, speed, turns, vector, derivative);
}

/* The triangles of edges, with the diagonal of the cube that each turns about. */
static const struct {
    double diagonal[3], edges[3][3], speed;
} triangles[4] = {
    {{1, 1, 1}, {{1, -1, 0}, {-1, 0, 1}, {0, 1, -1}}, 1},
    {{1, -1, -1}, {{1, 1, 0}, {-1, 0, -1}, {0, -1, 1}}, 1},
    {{-1, 1, -1}, {{-1, -1, 0}, {1, 0, -1}, {0, 1, 1}}, 2},
    {{-1, -1, 1}, {{-1, 1, 0}, {1, 0, 1}, {0, -1, -1}}, 2},
};

static void turn_in_space(unsigned index, double turns, double vector[3], double derivative[3])
{
    double g[3];
    oracle_gradient_vector(3, index, g);
    for (int n = 0; n < 12; n++) {
        const double *const edge = triangles[n / 3].edges[n % 3];
        if (edge[0] != g[0] || edge[1] != g[1] || edge[2] != g[2]) {
            continue;
        }
        double axis[3];
        for (int i = 0; i < 3; i++) {
            axis[i] = triangles[n / 3].diagonal[i] / sqrt(3.0);
        }
        oracle_turn_about(axis, g, triangles[n / 3].speed, turns, vector, derivative);
    }
}

void oracle_gradient_turned(int dimensions, unsigned index, double turns, double vector[3],
                            double derivative[3])
{
    if (dimensions == 2) {
        turn_in_plane(index, turns, vector, derivative);
    } else {
        turn_in_space(index, turns, vector, derivative);
    }
}
