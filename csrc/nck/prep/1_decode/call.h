// SPDX-License-Identifier: MIT
// How every call begins and ends.
#ifndef NCK_PREP_DECODE_CALL_H
#define NCK_PREP_DECODE_CALL_H

#include "nck/prep/1_decode/decode.h" // nck_decode_t

// The innermost call is over: it returns, or is done again. NCK_E_FLOW: there is none. Cost: linear
// in the parameters. Context: prep.
nck_status_t nck_call_return(nck_decode_t *self);

// Call what the key names, so many times. kind: of its frame. NCK_E_NO_SEEK, NCK_E_DEPTH,
// NCK_E_VARIABLES. Cost: linear in the parameters. Context: prep.
nck_status_t nck_call(nck_decode_t *self, nck_frame_kind_t kind, uint64_t key, uint32_t count);

#endif
