// SPDX-License-Identifier: MIT
// What a machine tells its controller.
#ifndef HAL_INPUT_H
#define HAL_INPUT_H

// What the machine tells, one bit each. 1: the axis is at its switch, the probe touches, the door
// is open, the emergency stop is pushed; so wire them that a broken wire reads 1.
typedef enum hal_input {
    HAL_IN_LIMIT = 0,      // and the axis: X is bit 0
    HAL_IN_HOME = 9,       // and the axis; may be the limit's own switch
    HAL_IN_PROBE = 18,
    HAL_IN_DOOR = 19,
    HAL_IN_EMERGENCY = 20,
    HAL_IN_SECOND = 21,    // home of the second motor of an axis that has two
    HAL_IN_SLOW = 22,      // the spindle has not its speed
    HAL_IN_PORT = 23       // and the port, 0 … 7: what M66 asks for
} hal_input_t;

#endif
