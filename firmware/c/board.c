/* Start of a Cortex-M4F and semihosting (Arm: Semihosting for AArch32 and AArch64, operations 0x04 and 0x18). */
#include "board.h"

extern uint32_t data_start[], data_end[], bss_start[], bss_end[];
extern const uint32_t data_source[];
extern uint32_t stack_top;

int main(void);

void reset(void)
{
    volatile uint32_t *const coprocessors = (volatile uint32_t *)0xe000ed88u;
    const uint32_t *from = data_source;
    uint32_t *to;
    for (to = data_start; to < data_end; to++)
        *to = *from++;
    for (to = bss_start; to < bss_end; to++)
        *to = 0;
    /* Full access to the floating-point unit, from the next instruction on. */
    *coprocessors |= 0xfu << 20;
    __asm volatile("dsb\nisb" ::: "memory");
    main();
    board_exit();
}

/* A fault: nothing more is printed, and the host finds lines missing. */
static void fault(void)
{
    board_exit();
}

__attribute__((section(".vectors"), used)) static const void *const vectors[] = {
    &stack_top, (const void *)reset, (const void *)fault, (const void *)fault,
    (const void *)fault, (const void *)fault, (const void *)fault,
};

static void semihosting(uint32_t operation, const void *argument)
{
    register uint32_t r0 __asm("r0") = operation;
    register const void *r1 __asm("r1") = argument;
    __asm volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
}

void board_print(const char *text)
{
    semihosting(0x04, text);
}

void board_print_hex(uint32_t number)
{
    char text[10] = " ";
    int place;
    for (place = 8; place > 0; place--) {
        text[place] = "0123456789abcdef"[number & 15];
        number >>= 4;
    }
    text[9] = 0;
    board_print(text);
}

void board_exit(void)
{
    semihosting(0x18, (const void *)0x20026);
    for (;;) {
    }
}
