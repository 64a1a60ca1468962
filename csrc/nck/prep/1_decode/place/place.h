// SPDX-License-Identifier: MIT
// Where the program's zero is and how its coordinates lie: offsets, tools, layouts, compensation.
//
// The face of the wing: what other wings call of it. Context of all: prep.
#ifndef NCK_PREP_DECODE_PLACE_PLACE_H
#define NCK_PREP_DECODE_PLACE_PLACE_H

#include "nck/prep/1_decode/state/room.h" // nck_decode_t

// ---- layout.c

// G15 G16 G50 G51 G50.1 G51.1 G68 G69. NCK_E_LAYOUT_ON, NCK_E_SCALE_UNIT, NCK_E_NUMBER_RANGE. Cost:
// constant.
nck_status_t nck_decode_layout(nck_decode_t *self, nck_block_t *out);

// First and second axis of the plane in force. Cost: constant.
void nck_plane_axes(const nck_decode_t *self, unsigned *u, unsigned *v);

// A way in the plane as it lies in the work system; returns by how much it is longer, < 0 if the
// plane is mirrored, 0 if its axes have not the same scale. Cost: constant.
double nck_layout_way(const nck_decode_t *self, double *way);

// 1 if the words name the radius of polar coordinates. Cost: constant.
int nck_layout_says_radius(const nck_decode_t *self);

// Is an axis neither mirrored nor scaled? NCK_E_LAYOUT_ON. Cost: constant.
nck_status_t nck_layout_spares(nck_decode_t *self, unsigned axis);

// The bit of a layout's code, 0: it is none; 1 if it cannot stand beside others; what cannot be
// done while one is in force: NCK_E_LAYOUT_ON. Cost: constant.
uint32_t nck_layout_bit(int64_t tenths);
int nck_layout_collides(uint32_t codes, uint32_t bit);
nck_status_t nck_layout_refuses(nck_decode_t *self);

// ---- table.c, tool.c

// A tool with what G10 has changed; returns 0 if the table has none of that number; what G10 has
// changed in it counts no more. Cost: linear in tools and parameters.
int nck_table_find(const nck_decode_t *self, uint32_t number, nck_tool_t *tool_out);
void nck_table_forget(nck_decode_t *self, uint32_t number);

// 1 if T may name it: 0, one of the table, or any where the machine has no table. Cost: linear in
// the tools.
int nck_tool_is_known(const nck_decode_t *self, uint32_t number);

// ---- turned.c

// The origin from its parts, after a change of one. Cost: constant.
void nck_decode_origin(nck_decode_t *self);

// By how much a work system, from 0, is turned [deg]. Cost: constant.
double nck_turned_by(const nck_decode_t *self, uint32_t system);

// Where an axis is in the program, counts. Cost: constant.
int64_t nck_turned_place(const nck_decode_t *self, unsigned axis);

// What cannot be done while the work system in force is turned: NCK_E_LAYOUT_ON. Cost: constant.
nck_status_t nck_turned_refuses(nck_decode_t *self);

// ---- tool.c

// T; a tool number. On Fanuc's lathes T0202: NCK_E_TOOL_UNKNOWN, NCK_E_COMP_ON. Cost: linear in the
// tools.
nck_status_t nck_decode_tool(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_set_tool(nck_decode_t *self, double value, nck_block_t *out);

// ---- place.c

// Offsets.
nck_status_t nck_decode_length(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_work(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_offset(nck_decode_t *self);

// ---- comp.c

// G40, G41, G42; what cannot be done while G41 or G42 is in force.
nck_status_t nck_decode_comp(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_comp_refuses(nck_decode_t *self);

// ---- target.c

// The machine position that the axis words name; axes without a word stay. absolute: 1: words count
// from the machine's zero (G53). NCK_E_NUMBER_RANGE. Cost: constant.
nck_status_t nck_decode_target(nck_decode_t *self, int absolute, int64_t *target_nm);

#endif
