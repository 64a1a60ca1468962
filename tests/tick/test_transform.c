// SPDX-License-Identifier: MIT
// Room 7: which axis drives which joint, and the nearest nanometre to where it is to be.
#include <string.h> // memset

#include "check.h"
#include "nck/tick/7_transform/transform.h" // nck_transform_tick

static nck_machine_t machine;
static nck_transform_t transform;
static nck_pose_t pose;
static nck_axes_t axes;

static void begin(void)
{
    nck_machine_default(&machine);
    memset(&pose, 0, sizeof pose);
}

static void transform_pose(void)
{
    nck_transform_init(&transform, &machine);
    memset(&axes, 0x55, sizeof axes); // nothing of it may be left
    nck_transform_tick(&transform, &pose, &axes);
}

static void check_rounding(check_t *check, double mm, long long nm)
{
    pose.axis[NCK_AXIS_X] = mm;
    transform_pose();
    CHECK_INT(check, axes.joint_nm[0], nm);
}

// 1/128 mm is 7812.5 nm to the bit. Rounded always down, or always up, a path to and fro would
// stand beside itself.
static void halves_go_to_the_even_nanometre(check_t *check)
{
    begin();
    check_rounding(check, 1.0 / 128.0, 7812);
    check_rounding(check, 3.0 / 128.0, 23438);
    check_rounding(check, -1.0 / 128.0, -7812);
    check_rounding(check, -3.0 / 128.0, -23438);
}

static void setpoints_are_the_nearest_nanometre(check_t *check)
{
    begin();
    check_rounding(check, 0.0, 0);
    check_rounding(check, 1.00000049, 1000000);
    check_rounding(check, 1.00000051, 1000001);
    check_rounding(check, -1.00000049, -1000000);
    check_rounding(check, -1.00000051, -1000001);
    check_rounding(check, 123456.789012, 123456789012);
}

static void pose_of_all_axes(void)
{
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        machine.axis[x].present = 1;
        pose.axis[x] = 1.0 + x;
    }
}

static void joints_are_the_axes_that_the_machine_has_in_their_order(check_t *check)
{
    begin();
    pose_of_all_axes();
    transform_pose();
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        const long long counts = x >= NCK_AXIS_A && x <= NCK_AXIS_C ? 1000000000 : 1000000;
        CHECK_INT(check, axes.joint_nm[x], (1 + x) * counts);
    }
    machine.axis[NCK_AXIS_Y].present = 0;
    transform_pose();
    CHECK_INT(check, axes.joint_nm[0], 1000000);
    CHECK_INT(check, axes.joint_nm[1], 3000000);
    CHECK_INT(check, axes.joint_nm[NCK_AXIS_MAX - 1], 0);
}

static void a_lathe_has_joints_for_its_radius_and_its_length(check_t *check)
{
    begin();
    pose_of_all_axes();
    machine.kinematics = NCK_KINEMATICS_LATHE_XZ;
    transform_pose();
    CHECK_INT(check, axes.joint_nm[0], 1000000);
    CHECK_INT(check, axes.joint_nm[1], 3000000);
    for (int k = 2; k < NCK_AXIS_MAX; k++) CHECK_INT(check, axes.joint_nm[k], 0);
}

int main(void)
{
    check_t check = {0};
    CHECK_RUN(&check, halves_go_to_the_even_nanometre);
    CHECK_RUN(&check, setpoints_are_the_nearest_nanometre);
    CHECK_RUN(&check, joints_are_the_axes_that_the_machine_has_in_their_order);
    CHECK_RUN(&check, a_lathe_has_joints_for_its_radius_and_its_length);
    return check_end(&check);
}
