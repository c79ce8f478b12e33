/* SPDX-License-Identifier: MIT
 *
 * The peers that were found when this was built. CMakeLists.txt defines SCARP_BENCH_<PEER> for
 * each.
 */
#include "peer.h"

static const struct bench_peer *const peers[] = {
#ifdef SCARP_BENCH_STB_PERLIN
    &bench_peer_stb_perlin,
#endif
#ifdef SCARP_BENCH_LIBNOISE
    &bench_peer_libnoise,
#endif
#ifdef SCARP_BENCH_FASTNOISELITE
    &bench_peer_fastnoiselite,
#endif
#ifdef SCARP_BENCH_FASTNOISE2
    &bench_peer_fastnoise2,
#endif
    &bench_peer_hand,
#ifdef SCARP_BENCH_PLAIN
    &bench_peer_plain,
#endif
    NULL};

const struct bench_peer *bench_peer_get(size_t index)
{
    return index < sizeof peers / sizeof peers[0] ? peers[index] : NULL;
}
