// SPDX-License-Identifier: MIT
// The report of a run, as text.
#ifndef APP_REPORT_H
#define APP_REPORT_H

#include "app/app.h" // app_t

// Write what happened. Cost: linear in it. Context: after os_stop.
void app_report(const app_t *app);

// Write which line of the job is wrong. Cost: constant. Context: before os_start.
void app_report_job(uint32_t line, app_job_status_t status);

#endif
