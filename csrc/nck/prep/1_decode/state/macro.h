// SPDX-License-Identifier: MIT
// What programs with parameters, calls, jumps and loops need: where the text comes from, the
// parameters, and what is in force.
#ifndef NCK_PREP_DECODE_STATE_MACRO_H
#define NCK_PREP_DECODE_STATE_MACRO_H

#include <stddef.h> // size_t
#include <stdint.h> // uint32_t

#include "nck/base/limits.h" // NCK_FRAME_ROWS NCK_LABEL_ROWS
#include "nck/base/source.h" // nck_source_t

// Bounds of what is remembered, and of patience.
enum {
    NCK_DECODE_LABELS = NCK_LABEL_ROWS, // targets of jumps that are remembered
    NCK_DECODE_JUMPS_MOST = 1000000,  // jumps backward before it does, whatever it moves
    NCK_DECODE_IDLE_MOST = 1000000    // lines without a block before a program counts as endless
};

// Of M97 the key of a frame is the number of the line and this.
#define NCK_LINE_KEY ((uint64_t)1 << 40)

enum { NCK_LABEL_MOST = 99999999, NCK_VARIABLE_LAST = 99999 }; // of O and N; of #

// What a parameter without a value is: no number of a program is as large.
#define NCK_NO_VALUE 1e301

#define NCK_VALUE_NEAR 1e-4 // RS274NGC: what differs by less is equal

// A place between two lines of the text.
typedef struct nck_text_place {
    size_t offset;
    uint32_t line;     // lines before it
    uint32_t after_cr; // 1: a line feed that comes next belongs to the line before
} nck_text_place_t;

// A parameter: key and value. A key is the number, or what a name comes to (variables.c).
typedef struct nck_variable {
    uint64_t key;
    double value;
} nck_variable_t;

// What a frame is of.
typedef enum nck_frame_kind {
    NCK_FRAME_SUB = 1,     // O word call: ends at endsub or return
    NCK_FRAME_PROGRAM = 2, // M98, M97: ends at M99, parameters are the caller's
    NCK_FRAME_MACRO = 3,   // G65, G66: the same, parameters of its own
    NCK_FRAME_CONTOUR = 4, // G70 P Q: ends behind line Q, parameters are the caller's
    NCK_FRAME_WHILE = 5,   // place: before the line of the condition
    NCK_FRAME_DO = 6,      // place: behind the line
    NCK_FRAME_REPEAT = 7   // the same
} nck_frame_kind_t;

// A call or a loop in force.
typedef struct nck_frame {
    uint64_t key;           // O word, program number, or the number behind DO
    nck_text_place_t place; // where a call returns to, where a loop goes on
    nck_text_place_t begin; // of what was called: where it begins
    uint32_t line;          // of the call
    uint32_t count;         // times that are left, this one included
    uint32_t base;          // of a call: what macro.base was before it
    uint32_t kind;          // nck_frame_kind_t
} nck_frame_t;

// What is looked for in the lines that come: they are passed over until it is found.
typedef enum nck_seek_kind {
    NCK_SEEK_NOT = 0,
    NCK_SEEK_SUB = 1,     // O… sub
    NCK_SEEK_PROGRAM = 2, // a lone O…
    NCK_SEEK_NUMBER = 3,  // N…
    NCK_SEEK_ENDSUB = 4,
    NCK_SEEK_ELSE = 5,    // else, elseif or endif
    NCK_SEEK_ENDIF = 6,
    NCK_SEEK_LOOP_END = 7,  // endwhile, endrepeat, or the while that ends a do: behind it
    NCK_SEEK_LOOP_TAIL = 8, // the same, which is done
    NCK_SEEK_END = 9        // END… of WHILE … DO…
} nck_seek_kind_t;

// The target of a jump that was met.
typedef struct nck_label {
    uint64_t key;
    nck_text_place_t place; // behind the line, of a number before it
    uint32_t kind;          // NCK_SEEK_SUB, NCK_SEEK_PROGRAM, NCK_SEEK_NUMBER
} nck_label_t;

// All of it.
typedef NCK_MACRO_STATE nck_macro {
    nck_source_t source;
    nck_text_place_t place; // where the next line begins, if there is a source
    nck_text_place_t line;  // where the line in work begins
    uint32_t reads;         // 1: there is a source
    uint32_t idle;          // lines read since the last block
    uint32_t jumped;        // 1: a call, a loop or a jump was met
    uint32_t back;          // jumps backward so far

    // Global parameters stand at the beginning, those of calls at the end, the latest call's last.
    // Between them, behind the global ones, wait the values that the line in work sets.
    nck_variable_t variable[NCK_VARIABLE_ROWS];
    uint32_t globals, waiting;
    uint32_t base, locals;  // of the call in force: rows base … locals − 1 from the end
    double returned;        // what the last call gave back
    uint32_t has_returned;

    nck_frame_t frame[NCK_FRAME_ROWS];
    uint32_t depth;
    nck_label_t label[NCK_DECODE_LABELS];
    uint32_t labels;        // met so far
    uint64_t absent;        // of a P that names no program as it is; 0: none yet
    uint64_t modal;         // G66: the program, called behind every move; 0: none
    uint32_t modal_base;    // macro.base where G66 stood

    struct {
        uint64_t key;
        size_t begin;       // offset where the search began
        uint32_t kind;      // nck_seek_kind_t
        uint32_t wrapped;   // 1: the end of the text was met
        uint32_t decides;   // 1: an elseif was found: its condition counts
        uint32_t from;      // the line that jumps
    } seek;
} nck_macro_t;

#endif
