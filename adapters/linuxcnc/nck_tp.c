// SPDX-License-Identifier: GPL-2.0-or-later
// LinuxCNC's side: a trajectory planner module (TPMOD) on libnck. The only file that includes
// LinuxCNC's headers, which is why it alone is under their licence.
//
//     motion-command-handler ─ tpAddLine, tpPause, … ─▶ planner.h ◀─ tpRunCycle ─ motion-controller
//
// Both run in the servo thread. Places cross this file in the machine's units; behind it they are
// mm and degrees.
#include "rtapi.h"
#include "rtapi_app.h"
#include "rtapi_string.h"
#include "hal.h"
#include "motion.h"
#include "motion_types.h"
#include "tp.h"

#include <math.h>   // fabs HUGE_VAL
#include <stdlib.h> // getenv

#include "planner.h"
#include "settings.h"

MODULE_AUTHOR("pycnc");
MODULE_DESCRIPTION("jerk-limited trajectory planner");
MODULE_LICENSE("GPL");

static int jerk = 0;
RTAPI_MP_INT(jerk, "jerk of every axis [units/s^3]; 0: as the INI says");
static int budget = 0;
RTAPI_MP_INT(budget, "thousands of instructions a cycle; 0: as the INI says");
static char *planner = NULL;
RTAPI_MP_STRING(planner, "jerk, optimal or linear; as the INI says");

// What a tuner looks at in halscope, in the machine's units.
typedef struct pins {
    hal_float_t *speed, *acceleration, *jerk;
    hal_s32_t *limit;          // nck_limit_t
    hal_s32_t *queue;          // moves that are not behind the tool
    hal_s32_t *work;           // in this cycle
    hal_s32_t *time, *time_max; // of this cycle, and of the longest [ns]
} pins_t;

static int component;
static pins_t *pins;
static planner_t self;
static settings_t settings;
static planner_hooks_t hooks;
static struct state_tag_t tags[MOVES_MAX]; // of the moves, in their ring
static emcmot_status_t *status;
static emcmot_config_t *config;
static uint32_t told_up_to;  // entries of the ring before this one have their tags
static const char no_reverse[] =
    "no way back over a thread, a tap, a feed a revolution or a locking indexer: the tool stays";
static char refused[SETTINGS_WHY]; // why it takes no move; empty: it does
static double v_limit = 1e9; // of the tool [mm/s]
static int forward = 1;      // 1, −1: how it turned when the pass began

static double scale(int axis) { return settings_scale(&settings, axis); }

static void from_pose(const EmcPose *pose, double *place) {
    const double units[MOVES_AXES] = {pose->tran.x, pose->tran.y, pose->tran.z, pose->a, pose->b,
                                      pose->c, pose->u, pose->v, pose->w};
    for (int k = 0; k < MOVES_AXES; k++) place[k] = units[k] * scale(k);
}

static void to_pose(const double *place, EmcPose *pose) {
    double units[MOVES_AXES];
    for (int k = 0; k < MOVES_AXES; k++) units[k] = place[k] / scale(k);
    pose->tran.x = units[0];
    pose->tran.y = units[1];
    pose->tran.z = units[2];
    pose->a = units[3];
    pose->b = units[4];
    pose->c = units[5];
    pose->u = units[6];
    pose->v = units[7];
    pose->w = units[8];
}

static void message(const char *text) { rtapi_print_msg(RTAPI_MSG_ERR, "nck_tp: %s\n", text); }

static int at_speed(void) {
    for (int n = 0; n < config->numSpindles; n++) {
        if (!status->spindle_status[n].at_speed) return 0;
    }
    return 1;
}

static spindle_status_t *spindle(void) { return &status->spindle_status[self.spindle]; }

static int spindle_index(int ask) {
    if (ask) spindle()->spindle_index_enable = 1;
    return spindle()->spindle_index_enable == 0;
}

static void spindle_turn(double share) { spindle()->speed *= share; }

// ---- moves

// From LinuxCNC 2.10 on a move tells its jerk; the Makefile looks into the headers.
#ifdef TP_TAKES_JERK
#define MOST_JERK , double ini_maxjerk
#define MOVE_JERK ini_maxjerk
#else
#define MOST_JERK
#define MOVE_JERK 0.0
#endif

static planner_order_t order_of(int motion, double vel, unsigned char enables, char waits,
                                int indexer) {
    const planner_order_t order = {vel, 0.0, 0.0, 0.0, motion, enables,
                                   motion == EMC_MOTION_TYPE_TRAVERSE, waits != 0, indexer};
    return order;
}

// The soft limits of an axis; both are zero where the host has not set them.
static void find_travel(void) {
    for (int k = 0; k < 3; k++) {
        const emcmot_axis_status_t *const axis = &status->axis_status[k];
        const int set = axis->min_pos_limit < axis->max_pos_limit;
        self.travel.least[k] = set ? axis->min_pos_limit * scale(k) : -HUGE_VAL;
        self.travel.most[k] = set ? axis->max_pos_limit * scale(k) : HUGE_VAL;
    }
}

// No override makes a move faster than ini_maxvel; an operator may have changed the travel.
static planner_order_t caps(planner_order_t order, double ini_maxvel, double acc, double jerk,
                            const struct state_tag_t *tag) {
    find_travel();
    order.blends = (uint8_t)(tag->packed_flags >> GM_FLAG_BLEND & 1u);
    order.v_most = ini_maxvel;
    order.a_most = acc;
    order.j_most = jerk;
    return order;
}

// An owner who starts LinuxCNC from his desktop sees no terminal: what is wrong with the INI file
// is told where he wants the machine to move.
static int added(int taken, struct state_tag_t tag) {
    if (refused[0]) message(refused);
    if (taken > 0) {
        for (uint32_t n = told_up_to; n != self.moves.head; n++) tags[n % MOVES_MAX] = tag;
        told_up_to = self.moves.head;
        self.modal.id++;
        return TP_ERR_OK;
    }
    if (taken == -3) message("an arc leaves the travel of an axis between its ends");
    return taken == 0 ? TP_ERR_ZERO_LENGTH : taken < -1 ? TP_ERR_RANGE : TP_ERR_FAIL;
}

int tpAddLine(TP_STRUCT *const tp, EmcPose end, int motion, double vel, double ini_maxvel,
              double acc MOST_JERK, unsigned char enables, char atspeed, int indexer,
              struct state_tag_t tag) {
    const planner_order_t order =
        caps(order_of(motion, vel, enables, atspeed, indexer), ini_maxvel, acc, MOVE_JERK, &tag);
    double place[MOVES_AXES];
    (void)tp;
    from_pose(&end, place);
    return added(planner_line(&self, &order, place), tag);
}

int tpAddCircle(TP_STRUCT *const tp, EmcPose end, PmCartesian center, PmCartesian normal, int turn,
                int motion, double vel, double ini_maxvel, double acc MOST_JERK,
                unsigned char enables, char atspeed, struct state_tag_t tag) {
    const planner_order_t order =
        caps(order_of(motion, vel, enables, atspeed, -1), ini_maxvel, acc, MOVE_JERK, &tag);
    const double unit = scale(0);
    const double centre[3] = {center.x * unit, center.y * unit, center.z * unit};
    const double along[3] = {normal.x, normal.y, normal.z};
    double place[MOVES_AXES];
    (void)tp;
    from_pose(&end, place);
    return added(planner_arc(&self, &order, place, centre, along, turn), tag);
}

int tpAddRigidTap(TP_STRUCT *const tp, EmcPose end, double vel, double ini_maxvel,
                  double acc MOST_JERK, unsigned char enables, double reverse,
                  struct state_tag_t tag) {
    const planner_order_t order =
        caps(order_of(EMC_MOTION_TYPE_FEED, vel, enables, 0, -1), ini_maxvel, acc, MOVE_JERK, &tag);
    double place[MOVES_AXES];
    (void)tp;
    from_pose(&end, place);
    return added(planner_tap(&self, &order, place, reverse), tag);
}

int tpSetId(TP_STRUCT *tp, int id) {
    (void)tp;
    self.modal.id = id;
    return TP_ERR_OK;
}

int tpSetTermCond(TP_STRUCT *tp, int cond, double tolerance) {
    (void)tp;
    if (cond < TC_TERM_COND_STOP || cond > TC_TERM_COND_TANGENT) return TP_ERR_FAIL;
    self.modal.path_mode = cond == TC_TERM_COND_STOP    ? NCK_PATH_STOP
                           : cond == TC_TERM_COND_EXACT ? NCK_PATH_EXACT
                                                        : NCK_PATH_CONTINUOUS;
    self.modal.tolerance = tolerance * scale(0);
    return TP_ERR_OK;
}

int tpSetDout(TP_STRUCT *const tp, int index, unsigned char start, unsigned char end) {
    (void)tp;
    (void)end;
    return planner_output(&self, 0, index, (double)start) > 0 ? TP_ERR_OK : TP_ERR_FAIL;
}

int tpSetAout(TP_STRUCT *const tp, unsigned char index, double start, double end) {
    (void)tp;
    (void)end;
    return planner_output(&self, 1, index, start) > 0 ? TP_ERR_OK : TP_ERR_FAIL;
}

int tpSetSpindleSync(TP_STRUCT *const tp, int spindle, double sync, int mode) {
    (void)tp;
    self.modal.spindle = spindle >= 0 && spindle < EMCMOT_MAX_SPINDLES ? (uint32_t)spindle : 0;
    self.modal.lead = fabs(sync) * scale(0);
    self.modal.speed = sync != 0.0 && mode != 0;
    return TP_ERR_OK;
}

// ---- the operator

int tpPause(TP_STRUCT *tp) {
    (void)tp;
    planner_pause(&self, 1);
    return TP_ERR_OK;
}

int tpResume(TP_STRUCT *tp) {
    (void)tp;
    planner_pause(&self, 0);
    return TP_ERR_OK;
}

int tpAbort(TP_STRUCT *tp) {
    (void)tp;
    planner_abort(&self);
    return TP_ERR_OK;
}

int tpSetRunDir(TP_STRUCT *const tp, tc_direction_t dir) {
    static int said; // asked for every cycle while adaptive feed is below zero
    const int turns = planner_reverse(&self, dir == TC_DIR_REVERSE);
    if (turns < 0 && !said) message(no_reverse);
    said = turns < 0;
    tp->reverse_run = self.reversed ? TC_DIR_REVERSE : TC_DIR_FORWARD;
    return turns > 0 ? TP_ERR_OK : TP_ERR_FAIL;
}

int tpSetVlimit(TP_STRUCT *tp, double limit) {
    (void)tp;
    v_limit = limit * scale(0);
    return TP_ERR_OK;
}

// ---- the cycle

// The host scales the move in work: by its kind's override, and by adaptive feed and feed hold. The
// planner looks further, so it wants both overrides.
static planner_wish_t wish_of(void) {
    planner_wish_t wish = {.v_most = v_limit, .single = status->stepping};
    if (self.state != PLANNER_FOLLOWS) forward = spindle()->speed < 0.0 ? -1 : 1;
    wish.turns = forward * spindle()->spindleRevs;
    wish.rps = fabs(spindle()->spindleSpeedIn);
    wish.rps_most = fabs(spindle()->speed * spindle()->net_scale) / 60.0;
    wish.axis_x = spindle()->xoffset * scale(0);
    wish.surface = fabs(spindle()->css_factor * spindle()->net_scale) * scale(0) / 60.0;
    const int scaled = status->enables_queued & FS_ENABLED;
    const int rapid = status->motionType == EMC_MOTION_TYPE_TRAVERSE;
    const double feed = scaled ? status->feed_scale : 1.0;
    const double traverse = scaled ? status->rapid_scale : 1.0;
    const double base = rapid ? traverse : feed;
    const double rest = base > 1e-6 ? status->net_feed_scale / base : 1.0;
    wish.feed = rest * feed;
    wish.rapid = rest * traverse;
    return wish;
}

// The move that the host is to hear of; NULL at rest.
static const move_t *move_told(void) {
    const uint32_t work = self.told.move;
    const uint32_t count = self.told.between ? moves_on(&self.moves, work) : work;
    const int kept = count - self.moves.tail < self.moves.head - self.moves.tail;
    return self.done || !kept ? NULL : moves_at(&self.moves, count);
}

static void report(void) {
    const planner_told_t *const told = &self.told;
    const move_t *const move = move_told();
    const double unit = scale(0);
    status->tcqlen = (unsigned)planner_depth(&self);
    status->current_vel = told->v / unit;
    status->requested_vel = move ? move->vel * status->net_feed_scale : 0.0;
    status->spindleSync = self.state == PLANNER_FOLLOWS && self.follow.phase > FOLLOW_INDEX;
    status->distance_to_go = told->to_go / unit;
    status->enables_queued = move ? move->enables : status->enables_new;
    to_pose(told->dtg, &status->dtg);
#ifdef TP_TAKES_JERK
    const PmCartesian along = {told->along[0], told->along[1], told->along[2]};
    status->current_acc = told->a / unit;
    status->current_jerk = told->j / unit;
    status->current_dir = along;
#endif
    *pins->speed = told->v / unit;
    *pins->acceleration = told->a / unit;
    *pins->jerk = told->j / unit;
    *pins->limit = (hal_s32_t)told->limit;
    *pins->queue = (hal_s32_t)status->tcqlen;
    *pins->work = (hal_s32_t)told->work;
}

int tpRunCycle(TP_STRUCT *tp, long period) {
    const planner_wish_t wish = wish_of();
    const long long begin = rtapi_get_time();
    const int rested = self.done != 0;
    (void)period;
    if (status->on_soft_limit && !rested) planner_abort(&self); // the host asks for it later
    planner_cycle(&self, &wish);
    tp->reverse_run = self.reversed ? TC_DIR_REVERSE : TC_DIR_FORWARD;
    report();
    const hal_s32_t time = (hal_s32_t)(rtapi_get_time() - begin);
    *pins->time = time;
    if (time > *pins->time_max) *pins->time_max = time;
    return rested && self.done ? TP_ERR_WAITING : TP_ERR_OK;
}

int tpGetPos(TP_STRUCT const *const tp, EmcPose *const pos) {
    (void)tp;
    to_pose(self.told.place, pos);
    return TP_ERR_OK;
}

int tpIsDone(TP_STRUCT *const tp) {
    (void)tp;
    return self.done != 0;
}

int tpQueueDepth(TP_STRUCT *const tp) {
    (void)tp;
    return planner_depth(&self);
}

int tpActiveDepth(TP_STRUCT *const tp) {
    (void)tp;
    return !self.done;
}

int tpGetMotionType(TP_STRUCT *const tp) {
    const move_t *const move = move_told();
    (void)tp;
    return move ? move->motion : 0;
}

int tpGetExecId(TP_STRUCT *tp) {
    const move_t *const move = move_told();
    (void)tp;
    return move ? move->id : 0;
}

struct state_tag_t tpGetExecTag(TP_STRUCT *const tp) {
    static const struct state_tag_t none;
    const move_t *const move = move_told();
    (void)tp;
    return move ? tags[move - self.moves.at] : none;
}

int tcqFull(TC_QUEUE_STRUCT const *const tcq) {
    (void)tcq;
    return moves_full(&self.moves);
}

// ---- set up

int tpSetPos(TP_STRUCT *tp, EmcPose const *const pos) {
    double place[MOVES_AXES];
    (void)tp;
    from_pose(pos, place);
    planner_put(&self, place);
    return TP_ERR_OK;
}

int tpClear(TP_STRUCT *const tp) {
    planner_put(&self, self.told.place);
    self.modal.id = 0;
    self.modal.path_mode = NCK_PATH_CONTINUOUS;
    self.modal.tolerance = 0.0;
    tp->reverse_run = TC_DIR_FORWARD;
    status->motionFlag |= EMCMOT_MOTION_INPOS_BIT;
    report();
    return TP_ERR_OK;
}

// The motion controller does not look at what is returned; its first call comes without a period.
int tpSetCycleTime(TP_STRUCT *tp, double secs) {
    (void)tp;
    if (!(secs > 0.0)) return TP_ERR_FAIL;
    if (secs == self.cycle_s) return TP_ERR_OK;
    if (planner_init(&self, &settings, &hooks, secs)) {
        if (refused[0]) self.cycle_s = 0.0;
        if (secs < 0.99e-3 && !SETTINGS_SHORT) message("slow at this servo period: build it anew, "
                                                       "pycnc linuxcnc build --short-servo");
        return TP_ERR_OK;
    }
    message("the servo period is outside of 0.01 to 100 ms: no move is taken");
    return TP_ERR_FAIL;
}

int tpCreate(TP_STRUCT *const tp, int size, int id) {
    (void)size;
    (void)id;
    if (!tp || !status || !hooks.v_max) return TP_ERR_FAIL;
    if (tpSetCycleTime(tp, 1e-3) != TP_ERR_OK) return TP_ERR_FAIL;
    return tpClear(tp);
}

int tpSetAmax(TP_STRUCT *tp, double amax) {
    (void)tp;
    self.a_path = amax * scale(0);
    return TP_ERR_OK;
}

// Each move has its own speed.
int tpSetVmax(TP_STRUCT *tp, double vmax, double ini_maxvel) {
    (void)tp;
    (void)vmax;
    (void)ini_maxvel;
    return TP_ERR_OK;
}

void tpMotFunctions(void (*dio)(int, char), void (*aio)(int, double), void (*set_unlock)(int, int),
                    int (*get_unlock)(int), double (*vel)(int), double (*acc)(int)) {
    const planner_hooks_t given = {dio, aio, set_unlock, get_unlock, vel, acc, at_speed,
                                  spindle_index, spindle_turn, message};
    hooks = given;
}

void tpMotData(emcmot_status_t *motion_status, emcmot_config_t *motion_config) {
    status = motion_status;
    config = motion_config;
}

static int make_pins(void) {
    pins = hal_malloc(sizeof *pins);
    return pins && !hal_pin_float_newf(HAL_OUT, &pins->speed, component, "nck-tp.speed")
           && !hal_pin_float_newf(HAL_OUT, &pins->acceleration, component, "nck-tp.acceleration")
           && !hal_pin_float_newf(HAL_OUT, &pins->jerk, component, "nck-tp.jerk")
           && !hal_pin_s32_newf(HAL_OUT, &pins->limit, component, "nck-tp.limit")
           && !hal_pin_s32_newf(HAL_OUT, &pins->queue, component, "nck-tp.queue")
           && !hal_pin_s32_newf(HAL_OUT, &pins->work, component, "nck-tp.work")
           && !hal_pin_s32_newf(HAL_OUT, &pins->time, component, "nck-tp.time")
           && !hal_pin_s32_newf(HAL_IO, &pins->time_max, component, "nck-tp.time-max");
}

static void tell_settings(void) {
    static const char letters[] = "XYZABCUVW";
    const int given = settings.budget > 0;
    rtapi_print_msg(RTAPI_MSG_ERR, "nck_tp: planner %s, budget %u 000 instructions a %s, %s\n",
                    settings_planner(&settings),
                    given ? (unsigned)settings.budget : (unsigned)SETTINGS_BUDGET,
                    given ? "cycle" : "millisecond", settings.mm_per_unit > 1.0 ? "inch" : "mm");
    for (int k = 0; k < MOVES_AXES && settings.slope != NCK_SLOPE_LINEAR; k++) {
        if (!(settings.axes >> k & 1u)) continue;
        rtapi_print_msg(RTAPI_MSG_ERR, "nck_tp: %c jerk %ld units/s^3%s\n", letters[k],
                        (long)(settings.jerk[k] / scale(k)),
                        settings.jerk[k] > 0.0 ? "" : ": none");
    }
}

int rtapi_app_main(void) {
    const settings_given_t given = {jerk, budget, planner};
    const int good = settings_read(&settings, getenv("INI_FILE_NAME"), &given, refused);
    if (good) refused[0] = '\0';
    else settings_rest(&settings);
    component = hal_init("nck_tp");
    if (component < 0) return component;
    if (!make_pins()) {
        hal_exit(component);
        return -1;
    }
    if (good) tell_settings();
    else message(refused);
    memset(tags, 1, sizeof tags); // every page is there before the first cycle
    hal_ready(component);
    return 0;
}

void rtapi_app_exit(void) { hal_exit(component); }

EXPORT_SYMBOL(tpMotFunctions); EXPORT_SYMBOL(tpMotData); EXPORT_SYMBOL(tpAbort);
EXPORT_SYMBOL(tpActiveDepth); EXPORT_SYMBOL(tpAddCircle); EXPORT_SYMBOL(tpAddLine);
EXPORT_SYMBOL(tpAddRigidTap); EXPORT_SYMBOL(tpClear); EXPORT_SYMBOL(tpCreate);
EXPORT_SYMBOL(tpGetExecId); EXPORT_SYMBOL(tpGetExecTag); EXPORT_SYMBOL(tpGetMotionType);
EXPORT_SYMBOL(tpGetPos); EXPORT_SYMBOL(tpIsDone); EXPORT_SYMBOL(tpPause);
EXPORT_SYMBOL(tpQueueDepth); EXPORT_SYMBOL(tpResume); EXPORT_SYMBOL(tpRunCycle);
EXPORT_SYMBOL(tpSetAmax); EXPORT_SYMBOL(tpSetAout); EXPORT_SYMBOL(tpSetCycleTime);
EXPORT_SYMBOL(tpSetDout); EXPORT_SYMBOL(tpSetId); EXPORT_SYMBOL(tpSetPos);
EXPORT_SYMBOL(tpSetRunDir); EXPORT_SYMBOL(tpSetSpindleSync); EXPORT_SYMBOL(tpSetTermCond);
EXPORT_SYMBOL(tpSetVlimit); EXPORT_SYMBOL(tpSetVmax); EXPORT_SYMBOL(tcqFull);
