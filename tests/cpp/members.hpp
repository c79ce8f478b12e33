/* SPDX-License-Identifier: MIT
 *
 * The spans of floats of each structure, as X(name, is of the plane). Made by
 * src/bindings/interface.py; do not change them by hand. */

#define SAMPLES_MEMBERS(X)                                                                         \
    X(value, true)                                                                                 \
    X(dx, true)                                                                                    \
    X(dy, true)                                                                                    \
    X(dz, false)                                                                                   \
    X(dxx, true)                                                                                   \
    X(dxy, true)                                                                                   \
    X(dxz, false)                                                                                  \
    X(dyy, true)                                                                                   \
    X(dyz, false)                                                                                  \
    X(dzz, false)                                                                                  \
    X(dphase, true)

#define FEATURES_MEMBERS(X)                                                                        \
    X(f1, true)                                                                                    \
    X(f2, true)                                                                                    \
    X(x, true)                                                                                     \
    X(y, true)                                                                                     \
    X(z, false)                                                                                    \
    X(dx1, true)                                                                                   \
    X(dy1, true)                                                                                   \
    X(dz1, false)                                                                                  \
    X(dx2, true)                                                                                   \
    X(dy2, true)                                                                                   \
    X(dz2, false)

#define FLOW_MEMBERS(X)                                                                            \
    X(vx, true)                                                                                    \
    X(vy, true)                                                                                    \
    X(vz, false)                                                                                   \
    X(vxx, true)                                                                                   \
    X(vxy, true)                                                                                   \
    X(vxz, false)                                                                                  \
    X(vyx, true)                                                                                   \
    X(vyy, true)                                                                                   \
    X(vyz, false)                                                                                  \
    X(vzx, false)                                                                                  \
    X(vzy, false)                                                                                  \
    X(vzz, false)

#define ERODED_MEMBERS(X)                                                                          \
    X(value, true)                                                                                 \
    X(dx, true)                                                                                    \
    X(dy, true)                                                                                    \
    X(displacement, true)                                                                          \
    X(displacement_dx, true)                                                                       \
    X(displacement_dy, true)
