/* SPDX-License-Identifier: MIT
 *
 * Prints where the members of struct scarp_noise are, by the names of ScarpNoise in
 * src/gpu/samples/Scarp.cs.
 */
#include <stddef.h>
#include <stdio.h>

#include "scarp.h"

#define PRINT(name, member) printf("%s %zu\n", name, offsetof(struct scarp_noise, member))

int main(void)
{
    PRINT("basis", basis);
    PRINT("fade", fade);
    PRINT("fractal", fractal);
    PRINT("rotate", rotate);
    PRINT("seed", seed);
    PRINT("frequency", frequency);
    PRINT("octaves", octaves);
    PRINT("lacunarity", lacunarity);
    PRINT("gain", gain);
    PRINT("amplitude", amplitude);
    PRINT("erosion", erosion);
    PRINT("phase", phase);
    PRINT("jitter", jitter);
    PRINT("sharpness", sharpness);
    PRINT("periodX", period[0]);
    PRINT("periodY", period[1]);
    PRINT("periodZ", period[2]);
    PRINT("ofOctaves", of_octaves);
    PRINT("warp", warp);
    PRINT("plan", plan);
    printf("size %zu\n", sizeof(struct scarp_noise));
    return 0;
}
