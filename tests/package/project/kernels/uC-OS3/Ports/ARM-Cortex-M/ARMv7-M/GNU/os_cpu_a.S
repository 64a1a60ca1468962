@ SPDX-License-Identifier: MIT
@ In place of the assembler part of µC/OS-III's Cortex-M port: some of the instructions that it is
@ made of, and that it gives interrupts a stack of their own when the kernel starts.
    .syntax unified
    .thumb
    .text
    .align 2

#if defined(__VFP_FP__) && !defined(__SOFTFP__)
    .global imitation_save_floats
    .thumb_func
imitation_save_floats:
    vstmdb r0!, {s16-s31}
    bx lr
#endif

    .global imitation_main_stack
    .thumb_func
imitation_main_stack:
    movw r0, #:lower16:OS_CPU_ExceptStkBase
    movt r0, #:upper16:OS_CPU_ExceptStkBase
    ldr r0, [r0]
    msr msp, r0
    bx lr
