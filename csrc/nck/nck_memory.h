// SPDX-License-Identifier: MIT
// libnck, what a kernel is made of: for the file that reserves its memory, and for nobody to read
// or write a member of.
#ifndef NCK_MEMORY_H
#define NCK_MEMORY_H

#ifdef __cplusplus
extern "C" {
#endif

#include "nck/base/link.h"                      // nck_link_t
#include "nck/base/terms.h"                     // nck_terms_t
#include "nck/prep/1_decode/decode.h"           // nck_decode_t
#include "nck/prep/2_toolcomp/toolcomp.h"       // nck_toolcomp_t
#include "nck/prep/3_smooth/smooth.h"           // nck_smooth_t
#include "nck/prep/4_lookahead/lookahead.h"     // nck_lookahead_t
#include "nck/prep/5_slope/slope.h"             // nck_slope_t
#include "nck/prep/5_slope/travel.h"            // nck_travel_t
#include "nck/tick/6_interpolate/interpolate.h" // nck_interpolate_t
#include "nck/tick/7_transform/transform.h"     // nck_transform_t
#include "nck/nck_session.h"                    // nck_t nck_command_t

// How far a flush has come.
typedef enum nck_flush_state {
    NCK_FLUSH_NOT = 0,
    NCK_FLUSH_ASKED = 1,  // decode still has blocks
    NCK_FLUSH_SMOOTH = 2, // smooth gives what it held back
    NCK_FLUSH_AHEAD = 3   // look-ahead places what it held back
} nck_flush_state_t;

// The kernel. The order of the members is the order of the flow, behind what is asked for most: on
// a microcontroller what is near the begin is reached by shorter code. They are its own:
// functions tell what others need. Once initialised it must not move, for it points into itself.
struct nck {
    nck_machine_t machine;
    nck_terms_t terms;
    nck_hooks_t hooks;
    nck_command_t command;
    struct {
        nck_block_t block;      // on its way from 2_toolcomp to 3_smooth
        nck_command_t heard;    // by 5_slope in its last step; hold: 1 at soft limits, too
        NCK_OPTIMAL_MEMBER(nck_command_t, planned) // heard when the plan in force was published
        uint8_t last;           // 1: toolcomp has the last blocks
        uint8_t ended;          // 1: no more blocks: END, end of text or a program error
        uint8_t given_up;       // 1: after NCK_E_INTERNAL
        uint8_t flush;          // nck_flush_state_t
        uint8_t checks;         // 1: blocks are dropped behind decode
        uint8_t stands;         // 1: single block keeps the path; tick's own, …
        uint32_t resumed;       // … and so often the operator had gone on until then
        uint32_t blocks;        // blocks so far, of all kinds
        uint32_t modes;         // in force behind the last block (in_force.h)
        nck_diagnostic_t diagnostic; // of a room behind 1_decode; code 0: none
        uint32_t steps;         // of nck_prep, 0 when it is done; any reads
    } wire;
    nck_interpolate_t interpolate;
    nck_transform_t transform;
    nck_decode_t decode;
    nck_toolcomp_t toolcomp;
    nck_smooth_t smooth;
    nck_lookahead_t lookahead;
    nck_travel_t travel;
    nck_slope_t slope;
    nck_link_t link;
};

#ifdef __cplusplus
}
#endif

#endif
