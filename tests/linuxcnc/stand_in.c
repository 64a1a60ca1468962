// SPDX-License-Identifier: GPL-2.0-or-later
// A stand-in for LinuxCNC's motion controller: loads the planner module, does to it what a script
// says, one servo cycle after the other, and writes down where the axes are in each.
//
//     stand_in nck_tp.so TRACE < SCRIPT         (INI_FILE_NAME names the machine's INI)
//
// Its answers are lines of text; TRACE gets a record of doubles for every cycle (see put_down).
// It is under LinuxCNC's licence because it includes LinuxCNC's headers.
#include "rtapi.h"
#include "hal.h"
#include "motion.h"
#include "motion_types.h"
#include "tp.h"

#include <dlfcn.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { AXES = 9, LINE = 512 };

static emcmot_status_t status;
static emcmot_config_t config;
static TP_STRUCT tp;
static FILE *trace;
static double v_max[AXES], a_max[AXES], goal[AXES]; // goal: where the last move ends
static double turns, rps;       // of the spindle, and its speed
static double rps_s = 1e9;      // by which it can change in a second
static double adaptive = 1.0;
static double j_max[AXES]; // as the host knows them; 0: it says nothing of jerk
static int held, id_for_step, unlocked, id;
static double soft[AXES][2];    // limits of joints, at which the host aborts; both 0: none
static int abort_in;            // cycles until the host's task has heard of them
static unsigned long long cycles, nanoseconds, worst;

// ---- what LinuxCNC gives to a module

static long heap[4096];
static size_t used;

int hal_init(const char *name) { (void)name; return 1; }
int hal_ready(int component) { (void)component; return 0; }
int hal_exit(int component) { (void)component; return 0; }
void *hal_malloc(long size) {
    void *const at = heap + used;
    used += ((size_t)size + sizeof *heap - 1) / sizeof *heap;
    return at;
}
int hal_pin_s32_newf(hal_pin_dir_t dir, hal_s32_t **pin, int component, const char *name, ...) {
    (void)dir; (void)component; (void)name;
    *pin = hal_malloc(sizeof **pin);
    return 0;
}
int hal_pin_float_newf(hal_pin_dir_t dir, hal_float_t **pin, int component, const char *name, ...) {
    (void)dir; (void)component; (void)name;
    *pin = hal_malloc(sizeof **pin);
    return 0;
}
long long rtapi_get_time(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (long long)t.tv_sec * 1000000000 + t.tv_nsec;
}
void rtapi_print_msg(msg_level_t level, const char *format, ...) {
    va_list rest;
    (void)level;
    va_start(rest, format);
    vfprintf(stderr, format, rest);
    va_end(rest);
}

void rtapi_print(const char *format, ...) { (void)format; }

// ---- what the motion controller gives to a planner

static void dio_write(int index, char value) {
    printf("dout %d %d at %llu %.6f\n", index, value, cycles, status.carte_pos_cmd.tran.x);
}
static void aio_write(int index, double value) {
    printf("aout %d %g at %llu %.6f\n", index, value, cycles, status.carte_pos_cmd.tran.x);
}
static void set_unlock(int joint, int unlock) {
    printf("unlock %d %d at %llu\n", joint, unlock, cycles);
    unlocked = unlock;
}
static int is_unlocked(int joint) { (void)joint; return unlocked; }
static double v_of(int axis) { return v_max[axis]; }
static double a_of(int axis) { return a_max[axis]; }

// ---- the planner

#define DOOR(name) static __typeof__(name) *p_##name;
#define DOORS DOOR(tpMotFunctions) DOOR(tpMotData) DOOR(tpCreate) DOOR(tpClear) \
    DOOR(tpSetCycleTime) DOOR(tpSetVlimit) DOOR(tpSetAmax) DOOR(tpSetPos) DOOR(tpSetTermCond) \
    DOOR(tpSetId) DOOR(tpAddLine) DOOR(tpAddCircle) DOOR(tpAddRigidTap) DOOR(tpRunCycle) \
    DOOR(tpGetPos) DOOR(tpIsDone) DOOR(tpQueueDepth) DOOR(tcqFull) DOOR(tpPause) DOOR(tpResume) \
    DOOR(tpAbort) DOOR(tpGetExecId) DOOR(tpGetMotionType) DOOR(tpSetDout) DOOR(tpSetAout) \
    DOOR(tpSetSpindleSync) DOOR(tpSetRunDir) DOOR(tpActiveDepth) DOOR(tpGetExecTag) \
    DOOR(tpSetVmax)
DOORS
#undef DOOR

static int load(const char *path) {
    void *const module = dlopen(path, RTLD_NOW | RTLD_GLOBAL);
    int (*begin)(void) = NULL;
    if (!module) {
        fprintf(stderr, "%s\n", dlerror());
        return 0;
    }
#define DOOR(name) p_##name = (__typeof__(name) *)dlsym(module, #name); if (!p_##name) return 0;
    DOORS
#undef DOOR
    begin = (int (*)(void))dlsym(module, "rtapi_app_main");
    return begin && begin() == 0;
}

static void put_down(const EmcPose *pos) {
    const double row[] = {pos->tran.x, pos->tran.y, pos->tran.z, pos->a, pos->b, pos->c, pos->u,
                          pos->v, pos->w, turns, status.current_vel, status.distance_to_go,
                          (double)p_tpGetExecId(&tp), (double)p_tpQueueDepth(&tp),
                          (double)p_tpIsDone(&tp), status.requested_vel,
#ifdef TP_TAKES_JERK
                          status.current_acc, status.current_jerk, status.current_dir.x,
                          status.current_dir.y, status.current_dir.z,
#endif
    };
    fwrite(row, sizeof row, 1, trace);
}

// Adaptive feed: below zero it runs in reverse, behind a rest.
static double adapted(void) {
    const int wanted = adaptive < 0.0 ? TC_DIR_REVERSE : TC_DIR_FORWARD;
    if (adaptive == 0.0 || wanted == tp.reverse_run) return fabs(adaptive);
    return p_tpSetRunDir(&tp, wanted) == TP_ERR_OK ? fabs(adaptive) : 0.0;
}

// The share of the programmed speed that the move in work is to have.
static void scale(void) {
    const int rapid = p_tpGetMotionType(&tp) == EMC_MOTION_TYPE_TRAVERSE;
    double net = 1.0;
    if (status.enables_queued & FS_ENABLED) net = rapid ? status.rapid_scale : status.feed_scale;
    if (status.enables_queued & AF_ENABLED) net *= adapted();
    if ((status.enables_queued & FH_ENABLED) && held) net = 0.0;
    status.net_feed_scale = net;
    status.motionType = p_tpGetMotionType(&tp);
}

// The spindle, until the end of the cycle: the place is for then.
static void turn(void) {
    const double most = status.spindle_status[0].speed / 60.0;
    const double css = status.spindle_status[0].css_factor / 60.0;
    const double radius = fabs(status.spindle_status[0].xoffset - status.carte_pos_cmd.tran.x);
    const double wanted = css > 0.0 ? fmin(css / fmax(radius, 1e-9), most) : most;
    rps += fmax(-rps_s * 1e-3, fmin(rps_s * 1e-3, wanted - rps));
    turns += rps * 1e-3;
    // the encoder counts from its index once that was asked for
    if (status.spindle_status[0].spindle_index_enable
        && floor(turns) != floor(turns - rps * 1e-3)) {
        turns -= rps > 0.0 ? floor(turns) : ceil(turns);
        status.spindle_status[0].spindle_index_enable = 0;
    }
    status.spindle_status[0].spindleSpeedIn = rps;
}

// The host looks at soft limits behind the planner; its task aborts some cycles later.
static void look_at_limits(void) {
    const EmcPose *const p = &status.carte_pos_cmd;
    const double place[3] = {p->tran.x, p->tran.y, p->tran.z};
    int beyond = 0;
    for (int k = 0; k < 3; k++) {
        if (soft[k][0] >= soft[k][1]) continue;
        beyond |= place[k] > soft[k][1] + 1e-12 || place[k] < soft[k][0] - 1e-12;
    }
    if (beyond && !status.on_soft_limit) {
        printf("limit %llu\n", cycles);
        abort_in = 20;
    }
    status.on_soft_limit = beyond;
    if (abort_in > 0 && --abort_in == 0) p_tpAbort(&tp);
}

static void cycle(void) {
    EmcPose pos;
    const long long begin = rtapi_get_time();
    status.spindle_status[0].spindleRevs = turns;
    scale();
    p_tpRunCycle(&tp, 1000000);
    const unsigned long long time = (unsigned long long)(rtapi_get_time() - begin);
    nanoseconds += time;
    if (time > worst) worst = time;
    p_tpGetPos(&tp, &pos);
    status.carte_pos_cmd = pos;
    status.id = p_tpGetExecId(&tp);
    look_at_limits();
    if (status.stepping && id_for_step != status.id) {
        p_tpPause(&tp);
        status.stepping = 0;
        status.paused = 1;
    }
    turn();
    put_down(&pos);
    cycles++;
}

// rest: all is done; still: the axes stand; settled: they have stood long enough for a spindle.
static void until(const char *what, int most) {
    EmcPose before = status.carte_pos_cmd;
    int n = 0, still = 0;
    const int to_end = strcmp(what, "rest") == 0, enough = strcmp(what, "still") == 0 ? 3 : 1500;
    for (; n < most && !(to_end ? p_tpIsDone(&tp) : still >= enough); n++) {
        cycle();
        still = memcmp(&before, &status.carte_pos_cmd, sizeof before) ? 0 : still + 1;
        before = status.carte_pos_cmd;
    }
    printf("%s %d\n", what, n < most ? n : -1);
}

// ---- the script

static unsigned char at_speed;
static int indexer = -1;
static double asked_v, asked_a; // of the moves that come, at most; 0: what the axes leave to them
static struct state_tag_t tag;

static EmcPose place_of(const double *n) {
    const EmcPose pose = {{n[0], n[1], n[2]}, n[3], n[4], n[5], n[6], n[7], n[8]};
    return pose;
}

// What the axes leave to the path of a move: along its direction, or on an arc the least of theirs.
static double left_of(const double *limit, const double *end, int straight) {
    double way[AXES], length = 0.0, least = HUGE_VAL;
    for (int k = 0; k < AXES; k++) {
        way[k] = end[k] - goal[k];
        if (k < 3) length += way[k] * way[k];
    }
    length = sqrt(length);
    for (int k = 0; k < AXES; k++) {
        const double share = straight && length > 0.0 ? fabs(way[k]) / length : 1.0;
        if (limit[k] > 0.0 && share > 0.0) least = fmin(least, limit[k] / share);
    }
    return least < HUGE_VAL ? least : 0.0;
}

#ifdef TP_TAKES_JERK
#define JERK , jerk
#else
#define JERK
#endif

static void move(const char *word, const double *n) {
    const EmcPose end = place_of(n + 1);
    const int straight = strcmp(word, "arc") != 0;
    const double v = asked_v > 0.0 ? asked_v : left_of(v_max, n + 1, straight);
    const double a = asked_a > 0.0 ? asked_a : left_of(a_max, n + 1, straight);
    const double jerk = left_of(j_max, n + 1, straight);
    int good = 0;
    (void)jerk;
    memcpy(goal, n + 1, sizeof goal);
    p_tpSetId(&tp, ++id);
    if (strcmp(word, "arc") == 0) {
        const PmCartesian centre = {n[10], n[11], n[12]}, normal = {n[13], n[14], n[15]};
        good = p_tpAddCircle(&tp, end, centre, normal, (int)n[16], EMC_MOTION_TYPE_ARC, n[0], v,
                             a JERK, status.enables_new, at_speed, tag);
    } else if (strcmp(word, "tap") == 0) {
        good = p_tpAddRigidTap(&tp, end, n[0], v, a JERK, status.enables_new, n[10], tag);
    } else {
        const int rapid = strcmp(word, "rapid") == 0;
        good = p_tpAddLine(&tp, end, rapid ? EMC_MOTION_TYPE_TRAVERSE : EMC_MOTION_TYPE_FEED, n[0],
                           v, a JERK, status.enables_new, at_speed, indexer, tag);
    }
    if (good) printf("move %d %d\n", id, good);
    at_speed = 0;
    indexer = -1;
}

static void operate(const char *word, const double *n) {
    if (strcmp(word, "pause") == 0) {
        p_tpPause(&tp);
        status.paused = 1;
    } else if (strcmp(word, "resume") == 0) {
        status.stepping = 0;
        status.paused = 0;
        p_tpResume(&tp);
    } else if (strcmp(word, "step") == 0) {
        if (!status.paused) return;
        id_for_step = status.id;
        status.stepping = 1;
        p_tpResume(&tp);
    } else if (strcmp(word, "abort") == 0) {
        p_tpAbort(&tp);
        status.stepping = status.paused = 0;
    } else if (strcmp(word, "clear") == 0) {
        p_tpClear(&tp);
    } else if (strcmp(word, "setpos") == 0) {
        const EmcPose pos = place_of(n);
        p_tpSetPos(&tp, &pos);
    } else if (strcmp(word, "reverse") == 0) {
        printf("reverse %d\n", p_tpSetRunDir(&tp, TC_DIR_REVERSE));
    } else if (strcmp(word, "forward") == 0) {
        printf("forward %d\n", p_tpSetRunDir(&tp, TC_DIR_FORWARD));
    }
}

static void set(const char *word, const double *n) {
    if (strcmp(word, "feed") == 0) status.feed_scale = n[0];
    else if (strcmp(word, "rapids") == 0) status.rapid_scale = n[0];
    else if (strcmp(word, "adaptive") == 0) adaptive = n[0];
    else if (strcmp(word, "feedhold") == 0) held = n[0] > 0.0;
    else if (strcmp(word, "enables") == 0) status.enables_new = (unsigned char)n[0];
    else if (strcmp(word, "vlimit") == 0) p_tpSetVlimit(&tp, n[0]);
    else if (strcmp(word, "amax") == 0) p_tpSetAmax(&tp, n[0]);
    else if (strcmp(word, "term") == 0) p_tpSetTermCond(&tp, (int)n[0], n[1]);
    else if (strcmp(word, "blends") == 0) tag.packed_flags = (unsigned long)n[0] << GM_FLAG_BLEND;
    else if (strcmp(word, "dout") == 0) p_tpSetDout(&tp, (int)n[0], (unsigned char)n[1], 0);
    else if (strcmp(word, "aout") == 0) p_tpSetAout(&tp, (unsigned char)n[0], n[1], 0.0);
    else if (strcmp(word, "period") == 0) printf("period %d\n", p_tpSetCycleTime(&tp, n[0]));
    else if (strcmp(word, "wait") == 0) at_speed = 1;
    else if (strcmp(word, "indexer") == 0) indexer = (int)n[0];
    else if (strcmp(word, "atspeed") == 0) status.spindle_status[0].at_speed = (int)n[0];
    else if (strcmp(word, "spindle") == 0) {
        status.spindle_status[0].speed = 60.0 * n[0];
        if (n[1] > 0.0) rps_s = n[1];
    }
    else if (strcmp(word, "sync") == 0) p_tpSetSpindleSync(&tp, 0, n[0], (int)n[1]);
    else if (strcmp(word, "css") == 0) {
        status.spindle_status[0].css_factor = n[0];
        status.spindle_status[0].xoffset = n[1];
    } else if (strcmp(word, "soft") == 0) {
        soft[(int)n[0]][0] = n[1];
        soft[(int)n[0]][1] = n[2];
    } else if (strcmp(word, "travel") == 0) {
        status.axis_status[(int)n[0]].min_pos_limit = n[1];
        status.axis_status[(int)n[0]].max_pos_limit = n[2];
    } else if (strcmp(word, "caps") == 0) {
        asked_v = n[0];
        asked_a = n[1];
    }
    else if (strcmp(word, "jerk") == 0) j_max[(int)n[0]] = n[1];
    else if (strcmp(word, "axis") == 0) {
        v_max[(int)n[0]] = n[1];
        a_max[(int)n[0]] = n[2];
    }
}

static void tell(void) {
    const EmcPose *const p = &status.carte_pos_cmd;
    printf("tell %.9f %.9f %.9f id %d done %d depth %d active %d v %.6f to_go %.6f dtg %.6f "
           "full %d\n", p->tran.x, p->tran.y, p->tran.z, p_tpGetExecId(&tp), p_tpIsDone(&tp),
           p_tpQueueDepth(&tp), p_tpActiveDepth(&tp), status.current_vel, status.distance_to_go,
           status.dtg.tran.x, p_tcqFull(&tp.queue));
}

static void obey(const char *word, const double *n) {
    static const char *const moves[] = {"line", "rapid", "arc", "tap"};
    static const char *const operators[] = {"pause", "resume", "step", "abort", "clear", "setpos",
                                            "reverse", "forward"};
    for (unsigned k = 0; k < sizeof moves / sizeof *moves; k++) {
        if (strcmp(word, moves[k]) == 0) {
            move(word, n);
            return;
        }
    }
    for (unsigned k = 0; k < sizeof operators / sizeof *operators; k++) {
        if (strcmp(word, operators[k]) == 0) {
            operate(word, n);
            return;
        }
    }
    if (strcmp(word, "run") == 0) {
        for (int k = 0; k < (int)n[0]; k++) cycle();
    } else if (strcmp(word, "rest") == 0 || strcmp(word, "still") == 0
               || strcmp(word, "settled") == 0) {
        until(word, (int)n[0]);
    } else if (strcmp(word, "tell") == 0) {
        tell();
    } else if (strcmp(word, "time") == 0) {
        printf("time %llu %llu %llu\n", cycles, cycles ? nanoseconds / cycles : 0, worst);
        cycles = nanoseconds = worst = 0;
    } else {
        set(word, n);
    }
}

static void set_up(void) {
    const EmcPose zero = {{0.0, 0.0, 0.0}, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
    status.feed_scale = status.rapid_scale = status.net_feed_scale = 1.0;
    status.enables_new = status.enables_queued = FS_ENABLED | FH_ENABLED | AF_ENABLED;
    status.spindle_status[0].at_speed = 1;
    status.spindle_status[0].net_scale = 1.0;
    config.numSpindles = 1;
    config.numDIO = config.numAIO = 8;
    config.arcBlendEnable = 1;
    config.arcBlendOptDepth = 50;
    config.arcBlendGapCycles = 4;
    config.arcBlendRampFreq = 100.0;
    config.arcBlendTangentKinkRatio = 0.1;
    config.trajCycleTime = 0.001;
    config.maxFeedScale = 2.0;
    p_tpMotFunctions(dio_write, aio_write, set_unlock, is_unlocked, v_of, a_of);
    p_tpMotData(&status, &config);
    if (p_tpCreate(&tp, 2000, 0) || p_tpSetCycleTime(&tp, 0.001)) puts("create refused");
    p_tpSetVlimit(&tp, 1e3);
    p_tpSetVmax(&tp, 1e3, 1e3);
    p_tpSetPos(&tp, &zero);
}

int main(int argc, char **argv) {
    char line[LINE];
    if (argc != 3 || !load(argv[1])) return 1;
    trace = fopen(argv[2], "wb");
    if (!trace) return 2;
    set_up();
    while (fgets(line, sizeof line, stdin)) {
        char word[32] = "", *at = line;
        double n[20] = {0.0};
        int count = 0, length = 0;
        if (sscanf(at, "%31s%n", word, &length) != 1) continue;
        at += length;
        while (count < 20 && sscanf(at, "%lf%n", &n[count], &length) == 1) {
            at += length;
            count++;
        }
        obey(word, n);
    }
    return fclose(trace) == 0 ? 0 : 3;
}
