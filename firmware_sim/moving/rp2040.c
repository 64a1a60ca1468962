// SPDX-License-Identifier: MIT
// An RP2040 (its datasheet): SysTick is the fast interrupt, PendSV the period, UART0 the line at
// 115 200 baud on GPIO 0 and 1. GPIO 2 … 4: step, 5 … 7: direction, 8: drives on; 10 … 12: home
// switches, 13: probe, 14: emergency stop, 15: the spindle has not its speed. The boot code has set
// 125 MHz for the processor and for clk_peri, and the vector table has the three handlers below.
#include "moving/moving.h"

#include "hal/input.h" // HAL_IN_HOME

#define REG(address) (*(volatile uint32_t *)(uintptr_t)(address))

#define SIO 0xd0000000u
#define UART0 0x40034000u
#define RESETS 0x4000c000u
#define PIN_CTRL(pin) REG(0x40014004u + 8u * (pin))
#define PAD(pin) REG(0x4001c004u + 4u * (pin))
#define SYSTICK 0xe000e010u
#define SCB_ICSR REG(0xe000ed04u)
#define SCB_SHPR3 REG(0xe000ed20u)

enum {
    CORE_HZ = 125000000, BAUD = 115200, STEP = 2, DIRECTION = 5, DRIVES = 8, HOME = 10, PROBE = 13,
    EMERGENCY = 14, SLOW = 15, UART0_IRQ = 20, AS_UART = 2, AS_SIO = 5
};

static uint32_t count; // fast interrupts since the last period

_Bool __atomic_compare_exchange_4(volatile void *at, void *expected, unsigned desired, _Bool weak,
                                  int success, int failure);
void SysTick_Handler(void);
void PendSV_Handler(void);
void UART0_IRQ_Handler(void);

static void begin_pins(void) {
    for (uint32_t pin = 0; pin < 2; pin++) PIN_CTRL(pin) = AS_UART;
    for (uint32_t pin = STEP; pin <= SLOW; pin++) PIN_CTRL(pin) = AS_SIO;
    for (uint32_t pin = HOME; pin <= SLOW; pin++) PAD(pin) = 0x4a; // in, pulled up
    REG(SIO + 0x24) = 0x7fu << STEP;                                    // out
}

void part_begin(void) {
    const uint32_t blocks = 1u << 5 | 1u << 8 | 1u << 22; // pins, pads, UART0
    const uint32_t rate = 8u * (CORE_HZ / BAUD);          // 128ths of 16 clocks a bit
    REG(RESETS) &= ~blocks;
    while ((REG(RESETS + 8u) & blocks) != blocks) continue;
    begin_pins();
    REG(UART0 + 0x24) = rate >> 7;
    REG(UART0 + 0x28) = (rate & 0x7fu) / 2u;
    REG(UART0 + 0x2c) = 3u << 5;                          // eight bits, no queue
    REG(UART0 + 0x30) = 1u << 9 | 1u << 8 | 1u;           // receives, sends, on
    REG(UART0 + 0x38) = 1u << 4;                          // an interrupt at each byte
    SCB_SHPR3 = 0x00400000u;                              // SysTick 0, PendSV 1
    REG(0xe000e400u + 4u * (UART0_IRQ / 4u)) = 0x80u << 8u * (UART0_IRQ % 4u);
    REG(0xe000e100u) = 1u << UART0_IRQ;
    REG(SYSTICK + 4u) = CORE_HZ / MOVING_FAST_HZ - 1u;
    REG(SYSTICK) = 7;
}

void part_step(uint32_t directions, uint32_t high) {
    REG(SIO + 0x14) = (directions & 7u) << DIRECTION;
    REG(SIO + 0x18) = (~directions & 7u) << DIRECTION;
    REG(SIO + 0x14) = high << STEP;
    REG(SIO + 0x18) = (~high & 7u) << STEP;
}

uint32_t part_inputs(void) {
    const uint32_t pins = REG(SIO + 0x04);
    const uint32_t homes = pins >> HOME & 7u;
    return homes << HAL_IN_HOME | homes << HAL_IN_LIMIT | (pins >> PROBE & 1u) << HAL_IN_PROBE
           | (pins >> EMERGENCY & 1u) << HAL_IN_EMERGENCY | (pins >> SLOW & 1u) << HAL_IN_SLOW;
}

void part_drives(uint32_t on) { REG(SIO + (on ? 0x14u : 0x18u)) = 1u << DRIVES; }

void part_send(uint8_t byte) {
    while (REG(UART0 + 0x18) & 1u << 5) continue;
    REG(UART0) = byte;
}

// The processor has no exclusive access, so the compiler calls this for the kernel's one exchange.
_Bool __atomic_compare_exchange_4(volatile void *at, void *expected, unsigned desired, _Bool weak,
                                  int success, int failure) {
    volatile uint32_t *const word = at;
    uint32_t *const wanted = expected, mask;
    (void)weak, (void)success, (void)failure;
    __asm__ volatile("mrs %0, primask\n\tcpsid i" : "=r"(mask)::"memory");
    const uint32_t is = *word;
    if (is == *wanted) *word = desired;
    __asm__ volatile("msr primask, %0" ::"r"(mask) : "memory");
    const _Bool done = is == *wanted;
    *wanted = is;
    return done;
}

void SysTick_Handler(void) {
    moving_fast();
    if (++count < MOVING_FAST_HZ / MOVING_PERIOD_HZ) return;
    count = 0;
    SCB_ICSR = 1u << 28; // PendSV: the period, when this is over
}

void PendSV_Handler(void) { moving_period(); }

void UART0_IRQ_Handler(void) {
    while ((REG(UART0 + 0x18) & 1u << 4) == 0) moving_receive((uint8_t)REG(UART0));
}
