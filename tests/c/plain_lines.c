// SPDX-License-Identifier: MIT
// Decodes lines of a kind, for who counts the instructions of `decode_all`: plain_lines KIND COUNT.
#include <stdio.h>
#include <stdlib.h> // strtoul
#include <string.h> // strcmp

#include "nck/prep/1_decode/decode.h" // nck_decode_t

static nck_decode_t decode;
static nck_machine_t machine;
static char text[1 << 20];

unsigned decode_all(size_t size);

static size_t add_line(char *out, const char *kind, unsigned k) {
    const char *const sign = k % 2 ? "-" : "";
    if (strcmp(kind, "arc") == 0) {
        return (size_t)sprintf(out, "G91 G%u X%s5.0 Y0.5 I%s2.50 J0.25\n", 2 + k % 2, sign, sign);
    }
    if (strcmp(kind, "macro") == 0) {
        return (size_t)sprintf(out, "#1=[#1+1] X[10*COS[#1*0.%u]] Y[#1/2]\n", k % 90 + 10);
    }
    const int full = strcmp(kind, "line") == 0;
    return (size_t)sprintf(out, full ? "G1 X%u.%03u Y-%u.%03u Z0.%u\n" : "X%u.%03u Y%u.%03u\n",
                           k % 50 + 10, k % 900 + 100, k % 30 + 10, k * 7 % 900 + 100, k % 9 + 1);
}

unsigned decode_all(size_t size) {
    nck_block_t block;
    size_t used = 0, taken;
    unsigned blocks = 0;
    nck_status_t status = NCK_OK;
    while (status != NCK_DONE && status >= NCK_OK) {
        status = nck_decode_pull(&decode, &block);
        blocks += status == NCK_OK;
        if (status != NCK_EMPTY) continue;
        if (used == size) {
            nck_decode_end(&decode);
            continue;
        }
        (void)nck_decode_push(&decode, text + used, size - used, &taken);
        used += taken;
    }
    return blocks;
}

int main(int argc, char **argv) {
    if (argc != 3) return 2;
    const unsigned count = (unsigned)strtoul(argv[2], NULL, 10);
    size_t size = (size_t)sprintf(text, "G21 G90 G17 G91.1 F1000\nG1 X0\n");
    for (unsigned k = 0; k < count && size < sizeof text - 80; k++) {
        size += add_line(text + size, argv[1], k);
    }
    nck_machine_default(&machine);
    nck_decode_init(&decode, &machine);
    return decode_all(size) == count + 2 ? 0 : 1;
}
