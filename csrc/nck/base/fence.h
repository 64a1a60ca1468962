// SPDX-License-Identifier: MIT
// The only file with atomics: loads, stores and one exchange between the prep and the tick context.
#ifndef NCK_BASE_FENCE_H
#define NCK_BASE_FENCE_H

#include <stdint.h> // uint32_t

// A load or store with its fence is shorter than the call of one.
#define NCK_ALWAYS __attribute__((always_inline))

// Read what the other context publishes; everything that it wrote before is visible afterwards.
static inline NCK_ALWAYS uint32_t nck_fence_load(const uint32_t *word) {
    return __atomic_load_n(word, __ATOMIC_ACQUIRE);
}

// Publish a word; everything written before is visible to whoever reads it.
static inline NCK_ALWAYS void nck_fence_store(uint32_t *word, uint32_t value) {
    __atomic_store_n(word, value, __ATOMIC_RELEASE);
}

// Replace expected by desired; 0 if the word was something else. Never spins.
static inline int nck_fence_exchange(uint32_t *word, uint32_t expected, uint32_t desired) {
    return __atomic_compare_exchange_n(word, &expected, desired, 0, __ATOMIC_ACQ_REL,
                                       __ATOMIC_ACQUIRE);
}

#endif
