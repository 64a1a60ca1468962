// SPDX-License-Identifier: MIT
// The C tests of one room in one program. tests_of_program.h, which the build makes and includes
// before all else, names them.
//
//     tests_smooth                     name the tests
//     tests_smooth test_smooth_words   run one; what follows is the test's own
#include <stdio.h>  // puts fprintf
#include <string.h> // strcmp

typedef struct test {
    const char *name;
    int (*run)(void);
    int (*run_with)(int argc, char **argv); // in place of run, if it takes arguments
} test_t;

#define TEST(name) {#name, name, NULL},
#define TEST_WITH(name) {#name, NULL, name},
static const test_t tests[] = {TESTS_OF_PROGRAM(TEST, TEST_WITH)};
#define TEST_COUNT (sizeof tests / sizeof *tests)

int main(int argc, char **argv)
{
    for (size_t k = 0; k < TEST_COUNT; k++) {
        const test_t *const test = &tests[k];
        if (argc < 2) {
            puts(test->name);
        } else if (strcmp(argv[1], test->name) == 0) {
            return test->run ? test->run() : test->run_with(argc - 1, argv + 1);
        }
    }
    if (argc >= 2) fprintf(stderr, "no test %s here\n", argv[1]);
    return argc >= 2;
}
