// SPDX-License-Identifier: MIT
// The small kernel under random use: tasks that lock, post, take, send and sleep in any order, with
// ticks that fall anywhere. What must hold whatever they do: one owner a mutex, nothing posted or
// sent is lost or doubled, a timeout is as long as it says, and everybody comes to the end.
#include "os_check.h"

#include <stdint.h> // uint64_t uintptr_t

enum { PLAYERS = 6, RUNS = 40, TICKS = 60, MESSAGE_MAX = 4000, SLOTS = 4, LOCKS = 2, TOP = 0 };

typedef struct player {
    uint64_t random;
    uint32_t priority;
    uint32_t posts, takes, sent, received;
} player_t;

typedef struct game {
    player_t players[PLAYERS];
    os_sem_t sem;
    os_queue_t queue;
    void *slots[SLOTS];
    os_mutex_t locks[LOCKS];
    uint32_t inside[LOCKS];            // owners in the region at this moment
    uint32_t overlaps;                 // seen: more than one
    uint32_t refused;                  // statuses that must not be
    uint32_t early, late;              // timeouts that were not as long as they should
    uint32_t ended;
    uint32_t next_message;
    uint8_t seen[MESSAGE_MAX];         // how often a message was received
} game_t;

static game_t game;

// Xorshift, G. Marsaglia 2003. 0 … n − 1.
static uint32_t random_below(player_t *player, uint32_t n)
{
    player->random ^= player->random << 13;
    player->random ^= player->random >> 7;
    player->random ^= player->random << 17;
    return (uint32_t)(player->random >> 33) % n;
}

// Nobody is above the task at TOP: it runs in the tick that ends its wait.
static void judge_timeout(const player_t *player, uint32_t begun, uint32_t timeout)
{
    const uint32_t waited = os_time() - begun;
    game.early += waited < timeout;
    game.late += player->priority == TOP && waited > timeout;
}

static int enter(player_t *player, uint32_t lock)
{
    const os_status_t status = os_mutex_pend(&game.locks[lock], random_below(player, 4));
    game.refused += status != OS_OK && status != OS_TIMED_OUT;
    if (status != OS_OK) return 0;
    game.inside[lock]++;
    game.overlaps += game.inside[lock] != 1;
    return 1;
}

static void leave(uint32_t lock)
{
    game.overlaps += game.inside[lock] != 1;
    game.inside[lock]--;
    game.refused += os_mutex_post(&game.locks[lock]) != OS_OK;
}

static void lock_and_work(player_t *player, uint32_t first)
{
    if (player->priority == TOP || !enter(player, first)) return; // TOP is above the ceilings
    os_spend(random_below(player, 60));
    const uint32_t what = random_below(player, 4);
    if (what == 0) os_delay(1);
    if (what == 1 && first == 0 && enter(player, 1)) { // always in this order
        os_spend(random_below(player, 60));
        leave(1);
    }
    leave(first);
}

static void take(player_t *player)
{
    const uint32_t begun = os_time(), timeout = random_below(player, 4);
    const os_status_t status = os_sem_pend(&game.sem, timeout);
    player->takes += status == OS_OK;
    if (status == OS_TIMED_OUT) judge_timeout(player, begun, timeout);
}

static void receive(player_t *player)
{
    void *message = NULL;
    const uint32_t begun = os_time(), timeout = random_below(player, 4);
    const os_status_t status = os_queue_pend(&game.queue, timeout, &message);
    if (status == OS_TIMED_OUT) judge_timeout(player, begun, timeout);
    if (status != OS_OK) return;
    player->received++;
    game.seen[(uintptr_t)message]++;
}

static void send(player_t *player)
{
    const uint32_t before = os_critical_enter();
    const uint32_t message = game.next_message;
    game.next_message += message + 1 < MESSAGE_MAX;
    os_critical_exit(before);
    const os_status_t status = os_queue_post(&game.queue, (void *)(uintptr_t)message);
    player->sent += status == OS_OK;
    game.refused += status != OS_OK && status != OS_FULL;
}

static void move(player_t *player)
{
    switch (random_below(player, 7)) {
    case 0: os_delay(random_below(player, 3)); break;
    case 1: lock_and_work(player, random_below(player, LOCKS)); break;
    case 2: game.refused += os_sem_post(&game.sem) != OS_OK; player->posts++; break;
    case 3: take(player); break;
    case 4: send(player); break;
    case 5: receive(player); break;
    default: os_spend(random_below(player, 200)); break;
    }
}

static void play(void *user)
{
    player_t *const player = user;
    while (os_time() < TICKS) {
        move(player);
        if (player->priority == TOP) os_delay(1); // the others want to play, too
    }
    const uint32_t before = os_critical_enter();
    game.ended++;
    os_critical_exit(before);
    if (game.ended == PLAYERS) os_stop();
}

static void deal(check_t *check, uint64_t seed)
{
    static const uint32_t priorities[PLAYERS] = {TOP, 3, 5, 6, 9, 13};
    memset(&game, 0, sizeof game);
    begin();
    (void)os_sem_create(&game.sem, 1);
    (void)os_queue_create(&game.queue, game.slots, SLOTS);
    for (uint32_t k = 0; k < LOCKS; k++) (void)os_mutex_create(&game.locks[k], 1 + k);
    for (uint32_t k = 0; k < PLAYERS; k++) {
        const uint32_t priority = priorities[k];
        game.players[k] = (player_t){.random = seed * 977 + k + 1, .priority = priority};
        for (int skip = 0; skip < 20; skip++) (void)random_below(&game.players[k], 2);
        CHECK_INT(check, os_task_create(priority, "player", play, &game.players[k],
                                        stacks[priority], sizeof stacks[0] / sizeof stacks[0][0]),
                  OS_OK);
    }
}

static void settle(check_t *check)
{
    player_t all = {0};
    uint32_t distinct = 0, doubled = 0;
    for (uint32_t k = 0; k < PLAYERS; k++) {
        all.posts += game.players[k].posts;
        all.takes += game.players[k].takes;
        all.sent += game.players[k].sent;
        all.received += game.players[k].received;
    }
    for (uint32_t k = 0; k < MESSAGE_MAX; k++) {
        distinct += game.seen[k] > 0;
        doubled += game.seen[k] > 1;
    }
    CHECK_INT(check, game.sem.count, 1 + all.posts - all.takes);
    CHECK_INT(check, game.queue.used, all.sent - all.received);
    CHECK_INT(check, distinct, all.received);
    CHECK_INT(check, doubled, 0);
    CHECK(check, all.posts > 0 && all.takes > 0 && all.received > 0);
}

static void nothing_breaks_in_random_use(check_t *check)
{
    for (uint32_t run = 0; run < RUNS && check->broken == 0; run++) {
        deal(check, run);
        run_by(check, 307 + 61 * (run % 12));
        settle(check);
        CHECK_INT(check, game.overlaps, 0);
        CHECK_INT(check, game.refused, 0);
        CHECK_INT(check, game.early, 0);
        CHECK_INT(check, game.late, 0);
        CHECK_INT(check, game.ended, PLAYERS);
        CHECK_INT(check, stage.faults, 0);
        if (check->broken > 0) printf("    in run %u\n", (unsigned)run);
    }
}

int main(void)
{
    check_t check = {0};
    CHECK_RUN(&check, nothing_breaks_in_random_use);
    return check_end(&check);
}
