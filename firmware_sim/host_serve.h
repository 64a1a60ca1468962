// SPDX-License-Identifier: MIT
// A machine that speaks grbl's protocol, on the host in virtual time: prep steps and ticks
// interleaved as in sim.h, bytes in and bytes out. Who calls it lets time pass.
#ifndef HOST_SERVE_H
#define HOST_SERVE_H

#include <stddef.h> // size_t

#include "host_switches.h" // host_switches_t
#include "inputs/inputs.h" // inputs_t
#include "nck/nck_session.h" // nck_t
#include "serve/serve.h" // serve_t

// Bytes that wait outside of the ring: so many may stand in front of a real-time one that is heard
// at once; and answers that nobody has taken, of which what finds no room is dropped and counted.
enum { HOST_IN = 4096, HOST_OUT = 65536 };

// All of it.
typedef struct host_serve {
    nck_t *nck;
    nck_decode_t room;
    serve_t serve;
    inputs_t inputs;
    host_switches_t switches;
    char own[HOST_IN];
    char *in;                // of so many bytes, a power of two
    uint32_t in_size, in_head, in_tail;
    char out[HOST_OUT];
    size_t out_count;
    uint64_t out_lost;
    uint64_t ticks, moving;  // so far; of them the setpoint changed in
    uint64_t hash;           // FNV-1a of the setpoints that changed
    double v_most;           // of any axis in a tick, as a share of its limit
    nck_pose_t pose;
    nck_axes_t axes;         // what the drives have
    nck_status_t status;     // of the last step
} host_serve_t;

// Begin at rest, with the banner to take. nck is initialised here and must outlive self.
// Returns as nck_init. Cost: constant. Context: any.
nck_status_t host_serve_init(host_serve_t *self, nck_t *nck, const nck_machine_t *machine);

// More memory for bytes that wait, so many of them, a power of two; it must outlive self. Right
// behind host_serve_init. Cost: constant.
void host_serve_lend(host_serve_t *self, char *bytes, uint32_t size);

// The machine has switches: inputs.set and switches as the caller has set them. Cost: constant.
void host_serve_connect(host_serve_t *self);

// What a record has kept: offsets and tools, and the place of modal->position_nm, which the next
// tick gives. moved: the axes did then, so that it is a guess, and the machine is locked. Right
// behind host_serve_init and host_serve_connect. Returns as nck_modal_set and nck_set_position.
// Cost: constant.
nck_status_t host_serve_restore(host_serve_t *self, const nck_modal_t *modal, int moved);

// Bytes arrive. Those that find no room in the ring wait outside, but for real-time ones. Returns
// how many were taken: fewer than n where too many wait. Cost: linear in them.
size_t host_serve_receive(host_serve_t *self, const char *bytes, size_t n);

// As serve_part; what waits is dropped, too. Cost: linear in it.
void host_serve_part(host_serve_t *self);

// Let so many periods pass, with so many steps of prep between two of them. Cost: linear in them.
void host_serve_run(host_serve_t *self, uint32_t ticks, uint32_t steps);

// Take the answers so far, n bytes at most. Returns how many. Cost: linear in them.
size_t host_serve_take(host_serve_t *self, char *bytes, size_t n);

#endif
