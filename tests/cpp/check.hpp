/* SPDX-License-Identifier: MIT
 *
 * What the tests of scarp.hpp share: arrays with a mark in them, and a count of failures.
 */
#ifndef SCARP_TEST_CHECK_HPP
#define SCARP_TEST_CHECK_HPP

#include <cstdio>
#include <cstring>
#include <utility>
#include <vector>

#include <scarp.hpp>

inline int failures = 0;

#define CHECK(condition)                                                                           \
    do {                                                                                           \
        if (!(condition)) {                                                                        \
            std::printf("FAILED: %s:%d: %s\n", __FILE__, __LINE__, #condition);                    \
            failures++;                                                                            \
        }                                                                                          \
    } while (0)

/* As many arrays as a structure has outputs, of one size, with a mark in each element */
struct arrays {
    arrays(std::size_t count, std::size_t size) : all(count, std::vector<float>(size, mark))
    {
    }
    static constexpr float mark = -12345;
    std::vector<std::vector<float>> all;

    std::vector<float> &operator[](std::size_t i)
    {
        return all[i];
    }
    bool are_untouched() const
    {
        for (const auto &each : all) {
            for (const float element : each) {
                if (element != mark) {
                    return false;
                }
            }
        }
        return true;
    }
    bool operator==(const arrays &other) const /* to the bit */
    {
        for (std::size_t i = 0; i < all.size(); i++) {
            if (all[i].size() != other.all[i].size() ||
                std::memcmp(all[i].data(), other.all[i].data(), all[i].size() * sizeof(float)) !=
                    0) {
                return false;
            }
        }
        return true;
    }
};

/* Whether a call fails with this status, and names this member */
template <class Call> bool fails(Call call, scarp_status status, const char *member)
{
    try {
        call();
    } catch (const scarp::error &error) {
        const char *const named = error.why.member;
        if (error.why.status == status &&
            (named == member || (named && member && !std::strcmp(named, member)))) {
            return true;
        }
        std::printf("status %d, %s\n", static_cast<int>(error.why.status), error.what());
    }
    return false;
}

/* The points of the tests: on either side of the origin, some cells apart */
template <class T> std::vector<T> coordinates(std::size_t count, double step)
{
    std::vector<T> all(count);
    for (std::size_t i = 0; i < count; i++) {
        all[i] = static_cast<T>((static_cast<double>(i) - 11) * step);
    }
    return all;
}

#endif
