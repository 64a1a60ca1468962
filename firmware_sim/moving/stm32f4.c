// SPDX-License-Identifier: MIT
// An STM32F4 (RM0090): TIM2 is the fast interrupt, PendSV the period, USART2 the line at 115 200
// baud on PA2 and PA3. PB0 … 2: step, PB4 … 6: direction, PB8: drives on; PC0 … 2: home switches,
// PC3: probe, PC4: emergency stop, PC5: the spindle has not its speed. The start-up code has set
// 84 MHz for APB1's timers, half of it for its peripherals, and the vector table has the three
// handlers below.
#include "moving/moving.h"

#include "hal/input.h" // HAL_IN_HOME

#define REG(address) (*(volatile uint32_t *)(uintptr_t)(address))

enum {
    RCC = 0x40023800, GPIOA = 0x40020000, GPIOB = 0x40020400, GPIOC = 0x40020800, // AHB1
    TIM2 = 0x40000000, USART2 = 0x40004400,                                       // APB1
    TIMER_HZ = 84000000, UART_HZ = 42000000, BAUD = 115200, TIM2_IRQ = 28, USART2_IRQ = 38
};

#define NVIC_ENABLE(irq) REG(0xe000e100u + 4u * ((irq) / 32u))
#define NVIC_PRIORITY(irq) (*(volatile uint8_t *)(uintptr_t)(0xe000e400u + (irq)))
#define SCB_ICSR REG(0xe000ed04u)
#define SCB_PENDSV_PRIORITY (*(volatile uint8_t *)(uintptr_t)0xe000ed22u)

static uint32_t count; // fast interrupts since the last period

void TIM2_IRQHandler(void);
void PendSV_Handler(void);
void USART2_IRQHandler(void);

void part_begin(void) {
    REG(RCC + 0x30) |= 0x7;                  // ports A, B, C
    REG(RCC + 0x40) |= 1u | 1u << 17;        // TIM2, USART2
    REG(GPIOA + 0x00) |= 0xa0;               // PA2, PA3: their other function, …
    REG(GPIOA + 0x20) |= 0x7700;             // number 7
    REG(GPIOB + 0x00) |= 0x11515;            // out: PB0 … 2, PB4 … 6, PB8
    REG(GPIOC + 0x0c) |= 0x555;              // in, pulled up: a closed switch opens to 1
    REG(USART2 + 0x08) = UART_HZ / BAUD;
    REG(USART2 + 0x0c) = 1u << 13 | 1u << 5 | 1u << 3 | 1u << 2; // on, receives, sends
    REG(TIM2 + 0x2c) = TIMER_HZ / MOVING_FAST_HZ - 1u;
    REG(TIM2 + 0x0c) = 1;                    // an interrupt at each update
    NVIC_PRIORITY(TIM2_IRQ) = 0x00;
    SCB_PENDSV_PRIORITY = 0x40;
    NVIC_PRIORITY(USART2_IRQ) = 0x80;
    NVIC_ENABLE(TIM2_IRQ) = 1u << TIM2_IRQ % 32;
    NVIC_ENABLE(USART2_IRQ) = 1u << USART2_IRQ % 32;
    REG(TIM2 + 0x00) = 1;
}

// The upper half of BSRR clears.
void part_step(uint32_t directions, uint32_t high) {
    const uint32_t up = directions & 7u;
    REG(GPIOB + 0x18) = up << 4 | (up ^ 7u) << 20;
    REG(GPIOB + 0x18) = high | (high ^ 7u) << 16;
}

uint32_t part_inputs(void) {
    const uint32_t pins = REG(GPIOC + 0x10);
    const uint32_t homes = pins & 7u;
    return homes << HAL_IN_HOME | homes << HAL_IN_LIMIT | (pins >> 3 & 1u) << HAL_IN_PROBE
           | (pins >> 4 & 1u) << HAL_IN_EMERGENCY | (pins >> 5 & 1u) << HAL_IN_SLOW;
}

void part_drives(uint32_t on) { REG(GPIOB + 0x18) = on ? 1u << 8 : 1u << 24; }

void part_send(uint8_t byte) {
    while ((REG(USART2) & 1u << 7) == 0) continue;
    REG(USART2 + 0x04) = byte;
}

void TIM2_IRQHandler(void) {
    REG(TIM2 + 0x10) = 0;
    moving_fast();
    if (++count < MOVING_FAST_HZ / MOVING_PERIOD_HZ) return;
    count = 0;
    SCB_ICSR = 1u << 28; // PendSV: the period, when this is over
}

void PendSV_Handler(void) { moving_period(); }

void USART2_IRQHandler(void) {
    if (REG(USART2) & 1u << 5) moving_receive((uint8_t)REG(USART2 + 0x04));
}
