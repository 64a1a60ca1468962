// SPDX-License-Identifier: MIT
// What is received: real-time bytes go into a ring of their own, all others into that of lines.
#include <string.h> // memchr

#include "nck/base/fence.h" // nck_fence_load nck_fence_store
#include "serve/parts.h"

enum { BEHIND_C2 = 4, FEED = 0x90, SPINDLE_LAST = 0x9d };

// In the order of serve_signal_t.
static const char signals[] = {'!', '\x84', '\x85', '\x18', '?', '~', '\x83', '\xa1', '\xa0'};

// A letter outside of ASCII counts for nothing, though its later bytes look like signals. C2 and a
// byte below A0 are no letter but a signal, as senders write it that know text alone.
static int is_of_letter(serve_t *self, uint8_t byte) {
    const uint32_t rest = self->in.rest;
    self->in.rest = 0;
    if (byte >= 0xc2 && byte <= 0xf4) {
        self->in.rest = byte == 0xc2 ? BEHIND_C2 : 1u + (byte >= 0xe0) + (byte >= 0xf0);
        return 1;
    }
    if (rest == 0 || (byte & 0xc0u) != 0x80u) return 0;
    if (rest == BEHIND_C2) return byte >= 0xa0;
    self->in.rest = rest - 1;
    return 1;
}

// Returns serve_signal_t, or −1: it is none.
static int signal_of(uint8_t byte) {
    const char *const at = memchr(signals, byte, sizeof signals);
    if (at != NULL) return (int)(at - signals);
    return (uint8_t)(byte - FEED) <= SPINDLE_LAST - FEED ? SERVE_OVERRIDE + byte - FEED : -1;
}

// A quarter of the room is for what stops.
static void put_signal(serve_t *self, int signal) {
    const uint32_t head = self->in.signal_head;
    const uint32_t used = head - nck_fence_load(&self->in.signal_tail);
    const uint32_t room = signal < SERVE_REPORT ? SERVE_SIGNALS : SERVE_SIGNALS * 3 / 4;
    if (used >= room) return;
    self->signal[head & (SERVE_SIGNALS - 1)] = (uint8_t)signal;
    nck_fence_store(&self->in.signal_head, head + 1);
}

int serve_has_room(const serve_t *self) {
    return self->in.head - nck_fence_load(&self->in.tail) < SERVE_RING - 1;
}

int serve_hear(serve_t *self, uint8_t byte) {
    if (is_of_letter(self, byte)) return 1;
    const int signal = signal_of(byte);
    if (signal < 0) return byte >= 0x80;
    put_signal(self, signal);
    return 1;
}

void serve_put(serve_t *self, uint8_t byte) {
    if (!serve_has_room(self)) {
        nck_fence_store(&self->in.lost, 1);
        return;
    }
    self->ring[self->in.head & (SERVE_RING - 1)] = (char)byte;
    nck_fence_store(&self->in.head, self->in.head + 1);
}

void serve_receive(serve_t *self, uint8_t byte) {
    if (serve_hear(self, byte)) return;
    serve_put(self, byte);
}
