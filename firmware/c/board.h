/* The emulated board: text to the host, and the end of the emulation. */
#ifndef BOARD_H
#define BOARD_H

#include <stdint.h>

/* Prints a text. */
void board_print(const char *text);

/* Prints ` ` and a number with eight hexadecimal digits. */
void board_print_hex(uint32_t number);

/* Ends the emulation, with success. */
void board_exit(void);

#endif
