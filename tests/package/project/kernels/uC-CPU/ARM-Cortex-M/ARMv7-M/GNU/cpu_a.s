@ SPDX-License-Identifier: MIT
@ In place of the assembler part of µC/CPU's Cortex-M port, which the preprocessor does not see.
    .syntax unified
    .thumb
    .text
    .align 2

    .global CPU_SR_Save
    .thumb_func
CPU_SR_Save:
    mrs r1, basepri
    msr basepri, r0
    isb
    mov r0, r1
    bx lr
