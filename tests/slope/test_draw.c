// SPDX-License-Identifier: MIT
// Room 5, jerk-limited: the cells of a ladder. Wherever the nodes of a plan stand still, every cell
// ends.
#include <math.h>   // isfinite
#include <string.h> // memset

#include "check.h"
#include "nck/prep/5_slope/draw.h" // nck_draw_cells

enum { CELLS = 5 };

static nck_machine_t machine;
static nck_link_t link;
static nck_plan_t now;
static nck_plan_t next;
static nck_node_t ring[NCK_NODE_MAX];
static nck_jerk_t jerk;

// A ladder of CELLS cells over one piece. standing: a bit for every node but the last, which rests.
static void begin(uint32_t standing)
{
    nck_machine_default(&machine);
    nck_link_init(&link);
    memset(&next, 0, sizeof next);
    nck_jerk_init(&jerk, &machine, &link, &now, &next);
    memset(ring, 0, sizeof ring);
    ring[0].length = (double)CELLS;
    ring[0].last = 1;
    ring[0].vv_piece = 1.0;
    next.end_s = -1.0;
    next.end_piece = 1;
    jerk.work.n = CELLS;
    for (uint32_t i = 0; i <= CELLS; i++) {
        jerk.rung_s[i] = (double)i;
        jerk.h[i] = 1.0;
        jerk.a_max[i] = 1000.0;
        jerk.j_max[i] = 10000.0;
        jerk.vv_cap[i] = 1.0;
        jerk.vv[i] = i == CELLS || standing >> i & 1u ? 0.0 : 1.0;
    }
    nck_link_tail_begin(&link);
}

static void every_cell_ends_and_keeps_the_caps_wherever_nodes_stand_still(check_t *check)
{
    const nck_pieces_t pieces = {ring, 0, 1, 0, 1};
    for (uint32_t standing = 0; standing < 1u << CELLS; standing++) {
        begin(standing);
        nck_status_t status = nck_draw_cells(&jerk, &pieces);
        while (status == NCK_OK) status = nck_draw_cells(&jerk, &pieces);
        CHECK_INT(check, status, NCK_DONE);
        if (!CHECK(check, isfinite(jerk.work.time) && jerk.work.time >= (double)CELLS)) {
            printf("    nodes %x: %g s\n", (unsigned)standing, jerk.work.time);
        }
    }
}

int main(void)
{
    check_t check = {0};
    CHECK_RUN(&check, every_cell_ends_and_keeps_the_caps_wherever_nodes_stand_still);
    return check_end(&check);
}
