// SPDX-License-Identifier: MIT
// Where the time of a plan goes: to which lines, sections of the program, or tools; and what takes
// time there that no axis makes: changes of tool and starts of the spindle.
#ifndef NCK_HOST_SHARE_H
#define NCK_HOST_SHARE_H

#include <stddef.h> // size_t

#include "nck/base/machine.h" // nck_machine_t
#include "nck/base/records.h" // nck_output_t

#ifdef __cplusplus
extern "C" {
#endif

// What belongs to one line, section or tool. Times in s.
typedef struct nck_host_share {
    uint32_t key;               // the tool's number; where lines are asked for: of the caller
    uint32_t line;              // the first source line that it has anything of; 0: none
    uint32_t tool_changes, spindle_starts;
    double cut_s, rapid_s, dwell_s;
} nck_host_share_t;

// All shares, and how a moment finds its own.
typedef struct nck_host_shares {
    nck_host_share_t *rows;     // NULL: not asked for
    size_t max, count;          // tools: rows in use; what is more belongs to the last one
    const uint32_t *row_of_line;// by source line; NULL: by tool
    uint32_t line_max;          // largest line that row_of_line has
    uint32_t tool;              // in the spindle
    uint32_t tool_next;         // T so far
    uint32_t turret;            // 1: T changes the tool at once (a lathe's turret), no M6
    uint32_t turns;             // M code that the spindle turns by: 3, 4; 0: at rest
    uint64_t tool_changes, spindle_starts; // of the whole plan
} nck_host_shares_t;

// What a share gets of a moment.
typedef enum nck_host_share_kind {
    NCK_HOST_SHARE_CUT = 0, NCK_HOST_SHARE_RAPID = 1, NCK_HOST_SHARE_DWELL = 2
} nck_host_share_kind_t;

// Begin with no tool, the spindle at rest, and nothing asked for. Cost: constant. Context: any.
void nck_host_share_init(nck_host_shares_t *self, const nck_machine_t *machine);

// Take what the path hands over, in order. Cost: linear in the tools. Context: any.
void nck_host_share_output(nck_host_shares_t *self, const nck_output_t *output);

// Add time of a source line, under the tool in the spindle. Cost: linear in the tools.
// Context: any.
void nck_host_share_add(nck_host_shares_t *self, uint32_t line, nck_host_share_kind_t kind,
                        double time_s);

#ifdef __cplusplus
}
#endif

#endif
