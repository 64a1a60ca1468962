// SPDX-License-Identifier: MIT
// Reads the words of an INI file that this planner needs.
#include "settings.h"

#include <ctype.h>  // isspace tolower toupper
#include <stdio.h>  // FILE fgets fopen snprintf
#include <stdlib.h> // strtod
#include <string.h> // memset strchr strcmp strlen

#include "nck/nck.h" // nck_slope_kind_t

enum { LINE = 1024, NAME = 32, JOINTS = 16 };

static const char letters[] = "XYZABCUVW";

// The text between blanks, in place.
static char *stripped(char *text) {
    char *end = text + strlen(text);
    while (isspace((unsigned char)*text)) text++;
    while (end > text && isspace((unsigned char)end[-1])) end--;
    *end = '\0';
    return text;
}

// The next line; one that ends in a backslash goes on in the next. Returns 0 where there is none.
static int next_line(FILE *file, char *line_out) {
    size_t n = 0;
    while (fgets(line_out + n, LINE - (int)n, file)) {
        n = strlen(line_out);
        const size_t ends = n - (size_t)(n > 0 && line_out[n - 1] == '\n');
        if (ends == 0 || line_out[ends - 1] != '\\') return 1;
        n = ends - 1;
        line_out[n] = '\0';
    }
    return n > 0;
}

// The first value of a word in a section. Returns 1 if there is one.
static int find(FILE *file, const char *section, const char *word, char *value_out) {
    char line[LINE];
    int within = 0;
    rewind(file);
    while (next_line(file, line)) {
        char *const text = stripped(line);
        char *const equals = strchr(text, '=');
        if (*text == '[') {
            char *const end = strchr(text, ']');
            if (end) *end = '\0';
            within = strcmp(text + 1, section) == 0;
        }
        if (!within || !equals || *text == '#' || *text == ';') continue;
        *equals = '\0';
        if (strcmp(stripped(text), word) != 0) continue;
        (void)snprintf(value_out, LINE, "%s", stripped(equals + 1));
        return 1;
    }
    return 0;
}

// The same as a number. Returns 1; 0 if there is none; −1 if it is no number above zero.
static int find_number(FILE *file, const char *section, const char *word, double *number_out) {
    char value[LINE];
    char *end = value;
    if (!find(file, section, word, value)) return 0;
    const double number = strtod(value, &end);
    if (end == value || !(number > 0.0) || number > 1e15) return -1;
    *number_out = number;
    return 1;
}

// A jerk [units/s³]; 0: none. Returns as find_number does.
static int find_jerk(FILE *file, const char *section, const char *word, double *jerk_out) {
    char value[LINE];
    char *end = value;
    if (!find(file, section, word, value)) return 0;
    const double none = strtod(value, &end);
    if (end == value || none != 0.0) return find_number(file, section, word, jerk_out);
    *jerk_out = 0.0;
    return 1;
}

double settings_scale(const settings_t *settings, int axis) {
    const int rotary = axis >= NCK_AXIS_A && axis <= NCK_AXIS_C;
    return rotary ? settings->deg_per_unit : settings->mm_per_unit;
}

static int fail(char *why, const char *what, const char *remedy) {
    (void)snprintf(why, SETTINGS_WHY, "%s: %s", what, remedy);
    return 0;
}

static int equals(const char *a, const char *b) {
    while (*a && tolower((unsigned char)*a) == tolower((unsigned char)*b)) {
        a++;
        b++;
    }
    return tolower((unsigned char)*a) == tolower((unsigned char)*b);
}

// The millimetres of a unit, by its name or by how many of it a millimetre has; 0: neither.
static double mm_per(const char *unit) {
    const double number = strtod(unit, NULL);
    if (equals(unit, "inch") || equals(unit, "in") || equals(unit, "imperial")) return 25.4;
    if (equals(unit, "mm") || equals(unit, "metric")) return 1.0;
    return number > 0.0 ? 1.0 / number : 0.0;
}

// Of angles a number counts as degrees.
static int read_units(settings_t *settings, FILE *file, char *why) {
    char value[LINE];
    if (find(file, "TRAJ", "LINEAR_UNITS", value)) {
        settings->mm_per_unit = mm_per(value);
        if (!(settings->mm_per_unit > 0.0)) {
            return fail(why, "[TRAJ] LINEAR_UNITS", "write mm or inch");
        }
    }
    if (find(file, "TRAJ", "ANGULAR_UNITS", value)) {
        const int radians = tolower((unsigned char)*value) == 'r';
        const int gons = tolower((unsigned char)*value) == 'g';
        settings->deg_per_unit = radians ? 57.295779513082323 : gons ? 0.9 : 1.0;
    }
    return 1;
}

static int axis_of(char letter) {
    const char *const at = letter ? strchr(letters, toupper((unsigned char)letter)) : NULL;
    return at ? (int)(at - letters) : -1;
}

static int read_axes(settings_t *settings, FILE *file, char *why) {
    char value[LINE];
    if (!find(file, "TRAJ", "COORDINATES", value)) {
        return fail(why, "[TRAJ] COORDINATES", "write the machine's axes, as X Y Z");
    }
    for (const char *at = value; *at; at++) {
        if (axis_of(*at) >= 0) settings->axes |= 1u << axis_of(*at);
    }
    return 1;
}

// The axes that trivkins' joints drive, in the order of the joints; an empty text for others.
static void read_joints(FILE *file, char *joints_out) {
    char value[LINE];
    *joints_out = '\0';
    if (!find(file, "KINS", "KINEMATICS", value)) return;
    if (strncmp(value, "trivkins", strlen("trivkins")) != 0) return;
    const char *at = strstr(value, "coordinates=");
    const char *const from = at ? at + strlen("coordinates=") : letters;
    int n = 0;
    for (at = from; *at && n < JOINTS && (isspace((unsigned char)*at) || axis_of(*at) >= 0); at++) {
        if (axis_of(*at) >= 0) joints_out[n++] = letters[axis_of(*at)];
    }
    joints_out[n] = '\0';
}

// The least jerk of the joints that drive an axis. Returns 1, 0 for none, −1 for a wrong one.
static int joint_jerk(FILE *file, const char *joints, char letter, double *jerk_out) {
    char section[NAME];
    int found = 0;
    for (int n = 0; joints[n]; n++) {
        double jerk = 0.0;
        if (joints[n] != letter) continue;
        (void)snprintf(section, sizeof section, "JOINT_%d", n);
        const int state = find_jerk(file, section, "MAX_JERK", &jerk);
        if (state < 0) return -1;
        const int less = jerk > 0.0 && (jerk < *jerk_out || !(*jerk_out > 0.0));
        if (state > 0 && (!found || less)) *jerk_out = jerk;
        found |= state;
    }
    return found;
}

// Jerk of an axis [units/s³]: its own, that of its joints, or that of all.
static int read_jerk(FILE *file, const char *joints, int axis, double *jerk_out) {
    char section[NAME];
    const int rotary = axis >= NCK_AXIS_A && axis <= NCK_AXIS_C;
    (void)snprintf(section, sizeof section, "AXIS_%c", letters[axis]);
    int state = find_jerk(file, section, "MAX_JERK", jerk_out);
    if (state == 0) state = joint_jerk(file, joints, letters[axis], jerk_out);
    if (state != 0) return state;
    return find_jerk(file, "TRAJ", rotary ? "MAX_ANGULAR_JERK" : "MAX_LINEAR_JERK", jerk_out);
}

// What LinuxCNC would fill in for a limit that is not there no machine is built for.
static int read_host(settings_t *settings, FILE *file, int axis, char *why) {
    static const char *const words[] = {"MAX_VELOCITY", "MAX_ACCELERATION"};
    char section[NAME], what[LINE];
    double *const values[] = {&settings->v_max[axis], &settings->a_max[axis]};
    (void)snprintf(section, sizeof section, "AXIS_%c", letters[axis]);
    for (int k = 0; k < 2; k++) {
        const int state = find_number(file, section, words[k], values[k]);
        *values[k] *= settings_scale(settings, axis);
        if (state > 0) continue;
        (void)snprintf(what, sizeof what, "[%s] %s is missing or no number above zero", section,
                       words[k]);
        return fail(why, what, "write what the axis can do");
    }
    return 1;
}

static int read_limits(settings_t *settings, FILE *file, const settings_given_t *given, char *why) {
    char joints[JOINTS + 1], what[LINE];
    int limited = 0;
    read_joints(file, joints);
    for (int k = 0; k < SETTINGS_AXES; k++) {
        double jerk = (double)given->jerk;
        if (!(settings->axes >> k & 1u)) continue;
        if (!read_host(settings, file, k, why)) return 0;
        const int state = given->jerk > 0 ? 1 : read_jerk(file, joints, k, &jerk);
        const int needed = settings->slope != NCK_SLOPE_LINEAR;
        if (state < 0 || (state == 0 && needed)) {
            (void)snprintf(what, sizeof what, "axis %c: MAX_JERK %s", letters[k],
                           state < 0 ? "is no number above zero" : "is missing");
            return fail(why, what, "write it into [JOINT_n], [AXIS_L], or [TRAJ] MAX_LINEAR_JERK "
                                   "or MAX_ANGULAR_JERK for all; docs/linuxcnc.md helps to choose");
        }
        settings->jerk[k] = jerk * settings_scale(settings, k);
        limited |= jerk > 0.0;
    }
    if (!limited) settings->slope = NCK_SLOPE_LINEAR;
    return 1;
}

// What owners call the kernel's slopes.
static const char *const planners[] = {
    [NCK_SLOPE_LINEAR] = "linear", [NCK_SLOPE_JERK] = "jerk", [NCK_SLOPE_OPTIMAL] = "optimal"};

const char *settings_planner(const settings_t *settings) { return planners[settings->slope]; }

static int read_planner(settings_t *settings, const char *name, char *why) {
    for (uint32_t slope = 0; slope < sizeof planners / sizeof *planners; slope++) {
        if (!equals(name, planners[slope])) continue;
        settings->slope = slope;
        return 1;
    }
    return fail(why, "planner", "write jerk, optimal or linear");
}

static int read_choices(settings_t *settings, FILE *file, const settings_given_t *given,
                        char *why) {
    char value[LINE];
    double number = (double)given->budget;
    if (find(file, "TRAJ", "NCK_PLANNER", value) && !given->planner) {
        if (!read_planner(settings, value, why)) return 0;
    }
    const int budget = given->budget > 0 ? 1 : find_number(file, "TRAJ", "NCK_BUDGET", &number);
    if (budget < 0 || number > 1e6) {
        return fail(why, "[TRAJ] NCK_BUDGET", "write thousands of instructions a cycle, from 1");
    }
    if (budget > 0 && number >= 1.0) settings->budget = (uint32_t)number;
    const int within = find_number(file, "TRAJ", "NCK_TOLERANCE", &number);
    if (within < 0) return fail(why, "[TRAJ] NCK_TOLERANCE", "write a length above zero");
    if (within > 0) settings->tolerance = number * settings->mm_per_unit;
    return 1;
}

// LinuxCNC hears of no refusal once its motion controller has begun, so it is told before.
static int read_period(FILE *file, char *why) {
    char remedy[NAME + NAME];
    double period_ns = 0.0;
    nck_range_t range;
    const int state = find_number(file, "EMCMOT", "SERVO_PERIOD", &period_ns);
    nck_machine_range(NCK_QUANTITY_PERIOD, &range);
    const int good = period_ns >= range.low * 1e9 - 0.5 && period_ns <= range.high * 1e9 + 0.5;
    if (state == 0 || good) return 1;
    (void)snprintf(remedy, sizeof remedy, "write %.0f to %.0f nanoseconds", range.low * 1e9,
                   range.high * 1e9);
    return fail(why, "[EMCMOT] SERVO_PERIOD", remedy);
}

static int read_file(settings_t *settings, FILE *file, const settings_given_t *given, char *why) {
    return read_period(file, why) && read_units(settings, file, why)
           && read_axes(settings, file, why) && read_choices(settings, file, given, why)
           && read_limits(settings, file, given, why);
}

void settings_rest(settings_t *settings) {
    const settings_t rest = {.mm_per_unit = 1.0, .deg_per_unit = 1.0, .axes = 1u,
                             .slope = NCK_SLOPE_LINEAR, .budget = 1, .tolerance = 0.05,
                             .v_max = {1.0}, .a_max = {1.0}};
    *settings = rest;
}

int settings_read(settings_t *settings, const char *path, const settings_given_t *given,
                  char *why) {
    memset(settings, 0, sizeof *settings);
    settings->mm_per_unit = 1.0;
    settings->deg_per_unit = 1.0;
    settings->slope = NCK_SLOPE_OPTIMAL;
    settings->tolerance = 0.05;
    settings->jerk_given = given->jerk > 0;
    if (given->jerk < 0 || given->budget < 0) {
        return fail(why, "jerk=, budget=", "write numbers above zero");
    }
    settings->budget = (uint32_t)given->budget;
    if (given->planner && !read_planner(settings, given->planner, why)) return 0;
    FILE *const file = path ? fopen(path, "r") : NULL;
    if (!file) return fail(why, path ? path : "no INI file", "start LinuxCNC with one");
    const int good = read_file(settings, file, given, why);
    (void)fclose(file);
    return good;
}
