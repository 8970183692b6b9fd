/*
 * The arm of specs/salman_rrr.yaml from C, on the emulated chip. For each of 2,000 cases it prints a digest of the results of
 * each function; firmware-host computes the same in Rust (host/src/c.rs) and compares.
 */
#include <stddef.h>
#include <stdint.h>

#include "board.h"
#include "salman_rrr.h"

#define CASES 2000

/* Marsaglia's xorshift with 64 bits, as in cases/src/random.rs. */
static uint64_t state = 3u * 0x9e3779b97f4a7c15u | 1u;

static uint64_t bits(void)
{
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return state * 0x2545f4914f6cdd1du;
}

static float between(float low, float high)
{
    return low + (high - low) * ((float)(bits() >> 40) / 16777216.0f);
}

/* FNV-1a with a shift, as in cases/src/digest.rs. */
static uint64_t digest;

static void start(void)
{
    digest = 0xcbf29ce484222325u;
}

static void word(uint32_t x)
{
    digest = (digest ^ x) * 0x100000001b3u;
    digest ^= digest >> 29;
}

static void number(float x)
{
    union {
        float number;
        uint32_t bits;
    } as = {x};
    /* What is no number is one value. */
    word(x == x ? as.bits : 0x7fc00000u);
}

static void numbers(const float *x, int count)
{
    int i;
    for (i = 0; i < count; i++)
        number(x[i]);
}

static void solution(const salman_rrr_solution_t *s)
{
    numbers(s->q, SALMAN_RRR_JOINTS);
    number(s->position_residual);
    number(s->orientation_residual);
    word(s->flags);
    word(s->free_joints);
    word(s->branch.shoulder | s->branch.elbow << 8 | s->branch.wrist << 16 | (uint32_t)s->branch.root << 24);
}

static void solutions(int32_t status, const salman_rrr_solutions_t *all)
{
    int i;
    start();
    word((uint32_t)status);
    word((uint32_t)all->count);
    number(all->gap);
    number(all->deviation);
    for (i = 0; i < all->count; i++)
        solution(&all->items[i]);
}

static void print(void)
{
    board_print_hex((uint32_t)(digest ^ digest >> 32));
}

int main(void)
{
    int i, k;
    for (i = 0; i < CASES; i++) {
        float q[SALMAN_RRR_JOINTS], q_ref[SALMAN_RRR_JOINTS], target[3], gap;
        int32_t pulses[SALMAN_RRR_JOINTS];
        uint16_t saturated;
        salman_rrr_pose_t pose;
        salman_rrr_jacobian_t jacobian;
        salman_rrr_solutions_t all;
        salman_rrr_solution_t one;
        salman_rrr_branch_t branch = {0, 0, 0, 0};

        for (k = 0; k < SALMAN_RRR_JOINTS; k++) {
            q[k] = between(-3.0f, 3.0f);
            /* Quarter turns: most such poses are singular. */
            if (i % 5 == 1)
                q[k] = 1.5707964f * (float)((int)(bits() >> 60) - 8);
            q_ref[k] = q[k] + between(-0.5f, 0.5f);
        }
        start();
        word((uint32_t)salman_rrr_forward(q, &pose));
        numbers(&pose.rotation[0][0], 12);
        for (k = 0; k < 3; k++) {
            union {
                uint32_t bits;
                float number;
            } any = {(uint32_t)(bits() >> 32)};
            target[k] = pose.translation[k];
            /* Out of reach; any bits at all. */
            if (i % 5 == 2)
                target[k] *= between(0.5f, 4.0f);
            if (i % 5 == 3)
                target[k] = any.number;
        }
        board_print("C");
        print();
        start();
        word((uint32_t)salman_rrr_jacobian(q, &jacobian));
        numbers(&jacobian.rows[0][0], 6 * SALMAN_RRR_JOINTS);
        print();
        start();
        word((uint32_t)salman_rrr_forward_and_jacobian(q, &pose, &jacobian));
        numbers(&pose.rotation[0][0], 12);
        numbers(&jacobian.rows[0][0], 6 * SALMAN_RRR_JOINTS);
        print();
        solutions(salman_rrr_inverse_near(target, q_ref, &all), &all);
        print();
        solutions(salman_rrr_inverse(target, &all), &all);
        print();
        if (all.count > 0)
            branch = all.items[i % all.count].branch;
        start();
        word((uint32_t)salman_rrr_inverse_branch(target, &branch, &one, &gap));
        number(gap);
        solution(&one);
        print();
        start();
        word((uint32_t)salman_rrr_to_pulses(q, pulses, &saturated));
        for (k = 0; k < SALMAN_RRR_JOINTS; k++)
            word((uint32_t)pulses[k]);
        word(saturated);
        salman_rrr_from_pulses(pulses, q);
        numbers(q, SALMAN_RRR_JOINTS);
        print();
        start();
        word((uint32_t)salman_rrr_forward(NULL, &pose));
        word((uint32_t)salman_rrr_inverse(target, NULL));
        print();
        board_print("\n");
    }
    return 0;
}
