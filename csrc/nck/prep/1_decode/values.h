// SPDX-License-Identifier: MIT
// The room's inner doors to parameters: those that programs set (variables.c) and those that the
// control keeps (system.c). Context of all: prep.
#ifndef NCK_PREP_DECODE_VALUES_H
#define NCK_PREP_DECODE_VALUES_H

#include "nck/prep/1_decode/decode.h" // nck_decode_t

// variables.c: the key of a name; a parameter that was set, NULL: it was not.
uint64_t nck_variable_name(const char *at, const char *end);
const double *nck_variable_find(const nck_decode_t *self, uint64_t key);

// variables.c: a value that counts from the end of the line on; all of them count now, or none if
// the line is wrong (its status, handed back); one more of the call in force. NCK_E_VARIABLES.
// Cost: linear in the parameters.
nck_status_t nck_variable_wait(nck_decode_t *self, uint64_t key, double value);
nck_status_t nck_variable_commit(nck_decode_t *self, nck_status_t line);
nck_status_t nck_variable_add(nck_decode_t *self, uint64_t key, double value);

// variables.c: a parameter that counts at once. NCK_E_VARIABLES. Cost: linear in the parameters.
nck_status_t nck_variable_set(nck_decode_t *self, uint64_t key, double value);

// variables.c: the key of what G10 has changed in a tool, and in the zero of G54.1 P; a program
// begins: only these stay. Cost: linear in the parameters.
uint64_t nck_variable_work(uint32_t number, unsigned axis);
uint64_t nck_variable_tool(uint32_t number, unsigned field);
void nck_variable_restart(nck_decode_t *self);

// variables.c: what must hold between two lines. Cost: constant.
int nck_variable_invariants(const nck_decode_t *self);

// variables.c: arguments that are kept for the next call (modal: of G66): the key of one; forget
// those of the call in force; copy those of the caller, whose rows begin at `from`.
uint64_t nck_variable_kept(uint64_t number, int modal);
void nck_variable_drop_kept(nck_decode_t *self, int modal);
nck_status_t nck_variable_copy_kept(nck_decode_t *self, uint32_t from, int modal);

// system.c: the value of a parameter; 1 if the control keeps it itself. NCK_E_UNSUPPORTED,
// NCK_E_OTHER_BASE, NCK_E_NUMBER_RANGE, NCK_E_COMP_ON, NCK_E_UNSET. Cost: linear in the parameters.
nck_status_t nck_parameter_number(nck_decode_t *self, uint32_t number, double *value_out);
nck_status_t nck_parameter_name(nck_decode_t *self, const char *at, const char *end,
                                double *value_out);
int nck_parameter_is_own(const nck_decode_t *self, uint32_t number);

// system.c: 1 if a parameter may be set and changes nothing of the path: Fanuc's #3001 … #3004,
// RS274NGC's #5599. Cost: constant.
int nck_parameter_is_switch(const nck_decode_t *self, uint32_t number);

// system.c: 1 if the control keeps a parameter itself and the program may set it to what it then
// is: Fanuc's #3003 #3004, RS274NGC's #5061 … #5070. Cost: constant.
int nck_parameter_is_free(const nck_decode_t *self, uint32_t number);

// system.c: the limit of the finding that one of these statuses becomes. Cost: constant.
double nck_parameter_limit(nck_status_t status);

// system.c: set one of Fanuc's work offsets, #5221 …, or its external one, #5201 …, in the
// units in force. NCK_E_UNSUPPORTED: it is none; NCK_E_COMP_ON, NCK_E_LAYOUT_ON, NCK_E_VALUE.
// Cost: constant.
nck_status_t nck_parameter_set_work(nck_decode_t *self, uint32_t number, double value);

// system.c: a probe has ended where the axes stand: #5061 … #5070. NCK_E_VARIABLES. Cost: linear in
// the parameters.
nck_status_t nck_parameter_set_probe(nck_decode_t *self, int touched);

#endif
