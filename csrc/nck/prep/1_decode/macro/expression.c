// SPDX-License-Identifier: MIT
// Values that are not plain numbers: parameters, functions, expressions. One pass with two short
// stacks; nothing calls itself.
#include "nck/prep/1_decode/macro/parts.h"
#include "nck/prep/1_decode/state/state.h" // nck_decode_fail_at nck_decode_only nck_value_index …
#include "nck/prep/1_decode/number/number.h" // nck_bits nck_exp nck_from_bcd nck_log …
#include "nck/base/real.h" // nck_fabs nck_rounded …
#include "nck/base/trig_math.h" // NCK_PI

#include <stddef.h> // NULL

enum { DEPTH = 24 }; // operands, and operators, that wait at once

static const double huge = 1e300;

// What waits on the stack of operators. The order within a kind is that of its table.
typedef enum operator {
    OPEN, PARAMETER, MINUS,
    ABS, ACOS, ASIN, ATAN, COS, EXP, FIX, FUP, LN, ROUND, SIN, SQRT, TAN, RND, SQR,
    POW, BIN, BCD, ADP, PRM, // from RND on Fanuc's alone
    ANGLE, RAISED, // ATAN and POW that wait for their second operand
    OR, XOR, AND, EQ, NE, LT, LE, GT, GE, MOD, ADD, SUBTRACT, TIMES, DIVIDE, POWER
} operator_t;

typedef struct work {
    nck_decode_t *self;
    const char *at;
    double value[DEPTH];
    uint8_t operator[DEPTH];
    unsigned values, operators;
    unsigned open; // brackets
    nck_status_t status;
} work_t;

static void fail(work_t *work, nck_status_t code, double value) {
    const double shown = value - value == 0.0 ? value : 0.0;
    if (work->status == NCK_OK) {
        work->status = nck_decode_fail_at(work->self, code, work->at, 0, shown, 0.0);
    }
}

static void refuse(work_t *work) { fail(work, NCK_E_EXPRESSION, 0.0); }

// What other languages have.
static void only(work_t *work, uint32_t whose) {
    if (work->status == NCK_OK) work->status = nck_decode_only(work->self, work->at, whose);
}

static void skip(work_t *work) { work->at = nck_decode_skip(work->at); }

static void push_operator(work_t *work, operator_t operator) {
    if (work->operators == DEPTH) {
        refuse(work);
        return;
    }
    work->operator[work->operators] = (uint8_t)operator;
    work->operators++;
}

static operator_t top(const work_t *work) {
    return work->operators > 0 ? (operator_t)work->operator[work->operators - 1] : OPEN;
}

// ---- arithmetic

static double in_degrees(double angle) { return angle * 180.0 / NCK_PI; }

static double trigonometric(work_t *work, operator_t function, double degrees) {
    double sine, cosine;
    nck_sincos((degrees - 360.0 * nck_floor(degrees / 360.0)) * NCK_PI / 180.0, &sine, &cosine);
    if (function == SIN) return sine;
    if (function == COS) return cosine;
    if (nck_fabs(cosine) > 0.0) return sine / cosine;
    fail(work, NCK_E_VALUE, degrees);
    return 0.0;
}

static double inverse(work_t *work, operator_t function, double x) {
    if (!(nck_fabs(x) <= 1.0)) fail(work, NCK_E_VALUE, x);
    const double other = nck_sqrt(nck_max(0.0, (1.0 - x) * (1.0 + x)));
    return in_degrees(function == ASIN ? nck_atan2(x, other) : nck_atan2(other, x));
}

static double root_or_log(work_t *work, operator_t function, double x) {
    const double least = function == LN ? 1e-300 : 0.0;
    if (!(x >= least)) {
        fail(work, NCK_E_VALUE, x);
        return 0.0;
    }
    return function == LN ? nck_log(x) : nck_sqrt(x);
}

static double rounded(const work_t *work, operator_t function, double x) {
    const int to_nearest = function == ROUND || function == RND; // halves away from zero
    // Down and up; in Fanuc's language towards zero and away from it.
    if (!to_nearest) {
        const int up = function == FUP;
        const int ceils = nck_is_fanuc(work->self) && x < 0.0 ? !up : up;
        return ceils ? -nck_floor(-x) : nck_floor(x);
    }
    return x < 0.0 ? -nck_floor(0.5 - x) : nck_floor(x + 0.5);
}

static int rounds(operator_t function) {
    return function == FIX || function == FUP || function == ROUND || function == RND;
}

// Fanuc's numbers as bits, and as two digits a byte.
static double coded(work_t *work, operator_t function, double x) {
    if (function == POW) refuse(work); // it has no second operand
    const double value = function == BIN ? nck_from_bcd(x) : nck_to_bcd(x);
    if (value < 0.0) fail(work, NCK_E_VALUE, x);
    return value;
}

static double function_of(work_t *work, operator_t function, double x) {
    if (rounds(function)) return rounded(work, function, x);
    if (function >= POW) return coded(work, function, x);
    switch (function) {
    case MINUS: return -x;
    case ABS: return nck_fabs(x);
    case EXP: return nck_exp(x);
    case SQRT:
    case SQR:
    case LN: return root_or_log(work, function, x);
    case ACOS:
    case ASIN: return inverse(work, function, x);
    default: return trigonometric(work, function, x);
    }
}

static double divided(work_t *work, operator_t operator, double a, double b) {
    if (!(nck_fabs(b) > 0.0)) {
        fail(work, NCK_E_VALUE, b);
        return 0.0;
    }
    if (operator == DIVIDE) return a / b;
    const double rest = nck_rest(a, b);
    return rest < 0.0 ? rest + nck_fabs(b) : rest;
}

static double raised(work_t *work, double a, double b) {
    const int whole = nck_floor(b) >= b;
    if ((a < 0.0 && !whole) || (!(nck_fabs(a) > 0.0) && b < 0.0)) {
        fail(work, NCK_E_VALUE, a);
        return 0.0;
    }
    return nck_power(a, b);
}

// Equal; without a value is equal to without a value alone (Fanuc's #0).
static int equal(const work_t *work, double a, double b) {
    const int a_is = nck_value_is(a), b_is = nck_value_is(b);
    if (!a_is || !b_is) return a_is == b_is;
    return nck_is_fanuc(work->self) ? a >= b && a <= b : nck_fabs(a - b) < NCK_VALUE_NEAR;
}

static double compared(operator_t operator, double a, double b) {
    switch (operator) {
    case LT: return a < b;
    case LE: return a <= b;
    case GT: return a > b;
    default: return a >= b;
    }
}

// AND, OR, XOR: of Fanuc's controls bit by bit, so that 6 AND 3 is 2; else 0 does not hold, and all
// other values do.
static double logical(work_t *work, operator_t operator, double a, double b) {
    const int fanuc = nck_is_fanuc(work->self);
    uint32_t left = nck_fabs(a) > 0.0, right = nck_fabs(b) > 0.0;
    if (fanuc && (!nck_bits(a, &left) || !nck_bits(b, &right))) fail(work, NCK_E_VALUE, a);
    if (operator == AND) return left & right;
    return operator == OR ? left | right : left ^ right;
}

static double counted(double value) { return nck_value_is(value) ? value : 0.0; }

static double binary(work_t *work, operator_t operator, double left, double right) {
    const double a = counted(left), b = counted(right);
    switch (operator) {
    case EQ: return equal(work, left, right);
    case NE: return !equal(work, left, right);
    case ADD: return a + b;
    case SUBTRACT: return a - b;
    case TIMES: return a * b;
    case DIVIDE:
    case MOD: return divided(work, operator, a, b);
    case POWER: return raised(work, a, b);
    case AND:
    case OR:
    case XOR: return logical(work, operator, a, b);
    default: return compared(operator, a, b);
    }
}

// ---- reduction

static double pop(work_t *work) {
    if (work->values == 0) {
        refuse(work);
        return 0.0;
    }
    work->values--;
    return work->value[work->values];
}

static void give(work_t *work, double value) {
    if (nck_value_is(value) && !(nck_fabs(value) < huge)) fail(work, NCK_E_VALUE, 0.0);
    if (work->values == DEPTH) {
        refuse(work);
        return;
    }
    work->value[work->values] = value;
    work->values++;
}

static int level_of(operator_t operator) {
    if (operator < OR) return 0;
    if (operator <= AND) return 1;
    if (operator <= GE) return 2;
    if (operator == ADD || operator == SUBTRACT) return 3;
    return operator == POWER ? 5 : 4;
}

// Do what waits and binds at least as closely as the level.
static void reduce(work_t *work, int level) {
    while (work->status == NCK_OK && level_of(top(work)) >= level) {
        const operator_t operator = top(work);
        work->operators--;
        const double right = pop(work), left = pop(work);
        give(work, binary(work, operator, left, right));
    }
}

static double parameter(work_t *work, double number) {
    uint32_t index = 0;
    double value = 0.0;
    if (!nck_value_index(number, &index)) {
        fail(work, NCK_E_NUMBER_RANGE, number);
        work->self->finding.error.letter = '#';
        work->self->finding.error.limit = NCK_VARIABLE_LAST;
        return 0.0;
    }
    const nck_status_t status = nck_parameter_number(work->self, index, &value);
    if (status != NCK_OK) {
        fail(work, status, index);
        work->self->finding.error.letter = '#';
        work->self->finding.error.limit = nck_parameter_limit(status);
    }
    return value;
}

// An operand stands complete: what stands before it is done. ATAN waits for its second operand.
static void complete(work_t *work) {
    while (work->status == NCK_OK && work->operators > 0) {
        const operator_t operator = top(work);
        if (operator == OPEN || operator >= OR) return;
        skip(work);
        if (operator == ATAN) {
            if (*work->at != '/') refuse(work);
            work->at++;
            work->operator[work->operators - 1] = (uint8_t)ANGLE;
            skip(work);
            if (*work->at != '[') refuse(work);
            return;
        }
        work->operators--;
        const double x = pop(work);
        if (operator == PARAMETER) give(work, parameter(work, x));
        else if (operator == ANGLE) give(work, in_degrees(nck_atan2(pop(work), counted(x))));
        else if (operator == RAISED) give(work, raised(work, counted(pop(work)), counted(x)));
        else give(work, function_of(work, operator, counted(x)));
    }
}

// ---- reading

static void read_function(work_t *work) {
    static const char names[] =
        "ABS ACOS ASIN ATAN COS EXP FIX FUP LN ROUND SIN SQRT TAN RND SQR POW BIN "
        "BCD ADP PRM ";
    const char *end = NULL;
    const unsigned place = nck_decode_listed(work->at, names, &end);
    const unsigned function = ABS + place - 1;
    if (place != 0 && function >= RND) only(work, NCK_TONGUES_FANUC);
    if (place == 0 || work->status != NCK_OK) {
        refuse(work);
        return;
    }
    if (function >= ADP) fail(work, NCK_E_UNSUPPORTED, 0.0);
    const char *const behind = nck_decode_skip(end);
    if (*behind != '[') refuse(work);
    work->at = behind;
    push_operator(work, (operator_t)function);
}

static void read_name(work_t *work) {
    double value = 0.0;
    const char *const end = nck_decode_name_end(work->at);
    if (end == NULL) {
        refuse(work);
        return;
    }
    const nck_status_t status = nck_parameter_name(work->self, work->at + 1, end - 1, &value);
    if (status != NCK_OK) fail(work, status, 0.0);
    work->at = end;
    give(work, value);
    complete(work);
}

// EXISTS[#<name>], EXISTS[#5]: whether the parameter was ever set.
static void read_exists(work_t *work, const char *end) {
    uint64_t key = 0;
    const char *at = nck_decode_skip(end);
    if (*at == '[') at = nck_decode_skip(at + 1);
    if (*at == '#') at = nck_decode_name_key(nck_decode_skip(at + 1), &key);
    else at = NULL;
    if (at != NULL) at = nck_decode_skip(at);
    if (at == NULL || *at != ']') {
        refuse(work);
        return;
    }
    work->at = at + 1;
    give(work, nck_variable_find(work->self, key) != NULL);
    complete(work);
}

static void read_number(work_t *work) {
    nck_number_t number;
    const char *const end = nck_number_read(work->self->line.text, work->at, &number);
    if (end == NULL) {
        refuse(work);
        return;
    }
    work->at = end;
    give(work, nck_number_real(&number));
    complete(work);
}

// A part of an operand. Returns 1 if the operand is complete, 0 if more of it follows.
static int read_operand(work_t *work) {
    skip(work);
    const char c = *work->at;
    if (c == '[') {
        push_operator(work, OPEN);
        work->open++;
        work->at++;
        return 0;
    }
    if (c == '#') {
        work->at = nck_decode_skip(work->at + 1);
        const int named = *work->at == '<';
        if (named) {
            only(work, NCK_TONGUE_LINUXCNC);
            read_name(work);
        } else push_operator(work, PARAMETER);
        return named;
    }
    if (c == '-' || c == '+') {
        if (c == '-') push_operator(work, MINUS);
        work->at++;
        return 0;
    }
    if (nck_is_digit(c) || c == '.') {
        read_number(work);
        return 1;
    }
    const char *const exists = nck_decode_spells(work->at, "EXISTS");
    if (exists == NULL) read_function(work);
    else {
        only(work, NCK_TONGUE_LINUXCNC);
        read_exists(work, exists);
    }
    return exists != NULL;
}

// The operator between two operands, 0: none stands here.
static operator_t read_binary(work_t *work) {
    static const char signs[] = {'+', '-', '*', '/'};
    const char *end = work->at + 1;
    for (unsigned k = 0; k < sizeof signs; k++) {
        if (*work->at != signs[k]) continue;
        const int power = ADD + k == TIMES && *end == '*';
        if (power) only(work, NCK_TONGUE_LINUXCNC);
        work->at = power ? end + 1 : end;
        return power ? POWER : (operator_t)(ADD + k);
    }
    const unsigned place = nck_decode_listed(work->at, "OR XOR AND EQ NE LT LE GT GE MOD ", &end);
    if (place == 0) return OPEN;
    work->at = end;
    return (operator_t)(OR + place - 1);
}

// ATAN[y, x]: Fanuc's way; POW[x, y].
static void next_argument(work_t *work) {
    only(work, NCK_TONGUES_FANUC);
    reduce(work, 1);
    const unsigned n = work->operators;
    const operator_t function = n < 2 ? OPEN : (operator_t)work->operator[n - 2];
    if (function != ATAN && function != POW) {
        refuse(work);
        return;
    }
    work->operator[n - 2] = (uint8_t)(function == ATAN ? ANGLE : RAISED);
    work->at++;
}

// Behind an operand. Returns 1 if another one follows.
static int read_behind(work_t *work, int bare) {
    while (work->status == NCK_OK) {
        skip(work);
        if (top(work) == ANGLE) return 1;
        if (work->open == 0 && !bare) return 0;
        if (*work->at == ']' && work->open > 0) {
            reduce(work, 1);
            if (work->operators == 0) refuse(work);
            else work->operators--; // the bracket
            work->open--;
            work->at++;
            complete(work);
            continue;
        }
        if (*work->at == ',' && work->open > 0) {
            next_argument(work);
            return 1;
        }
        const operator_t operator = read_binary(work);
        if (operator == OPEN) {
            if (work->open > 0) refuse(work);
            return 0;
        }
        reduce(work, level_of(operator));
        push_operator(work, operator);
        return 1;
    }
    return 0;
}

nck_status_t nck_decode_value(nck_decode_t *self, const char **at, int bare, double *value_out) {
    work_t work;
    if (!NCK_HAS_VARIABLES) {
        return nck_decode_fail_at(self, NCK_E_UNSUPPORTED, *at, 0, 0.0, 0.0);
    }
    const nck_status_t speaks = nck_decode_only(self, *at, NCK_TONGUES_MACRO);
    if (speaks != NCK_OK) return speaks;
    work.self = self;
    work.at = *at;
    work.values = 0;
    work.operators = 0;
    work.open = 0;
    work.status = NCK_OK;
    for (int more = 1; more && work.status == NCK_OK;) {
        while (work.status == NCK_OK && !read_operand(&work)) continue;
        more = read_behind(&work, bare);
    }
    if (work.status == NCK_OK) reduce(&work, 1);
    if (work.status == NCK_OK && (work.values != 1 || work.operators != 0)) refuse(&work);
    *value_out = work.status == NCK_OK ? work.value[0] : 0.0;
    *at = work.at;
    return work.status;
}

// 15 digits: what two roundings of a double add to a decimal is gone.
void nck_decode_number(double value, nck_number_t *out) {
    if (!NCK_HAS_VARIABLES) return;
    const double magnitude = nck_min(nck_fabs(value), 1e15);
    double power = 1.0;
    int decimals = 0;
    while (magnitude * power < 1e14 && decimals < 15) {
        power *= 10.0;
        decimals++;
    }
    out->mantissa = nck_rounded(magnitude * power);
    out->decimals = (int16_t)decimals;
    out->first = 0;
    out->last = 0;
    out->negative = value < 0.0;
    out->longer = 0;
}
