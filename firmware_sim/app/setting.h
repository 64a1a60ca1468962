// SPDX-License-Identifier: MIT
// The numbers of the machine by their names: those of nck_machine_t's members.
#ifndef APP_SETTING_H
#define APP_SETTING_H

#include "app/number.h" // app_word_t
#include "nck/nck.h"    // nck_machine_t

// What setting a number returns.
typedef enum app_setting_status {
    APP_SETTING_OK = 0,
    APP_SETTING_E_NAME = -1,  // no such number
    APP_SETTING_E_INDEX = -2, // no such row or column
    APP_SETTING_E_VALUE = -3  // not a number of its type
} app_setting_status_t;

// Set one number. row and column are 0 where the member is no array; of an array of records the row
// is the record. Whether the machine makes sense is for nck_init to say.
// Returns an app_setting_status_t. Cost: linear in the settings there are. Context: any.
app_setting_status_t app_setting(nck_machine_t *machine, const app_word_t *name, int64_t row,
                                 int64_t column, const app_word_t *value);

#endif
