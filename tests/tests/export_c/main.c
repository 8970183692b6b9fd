/* Calls every function of an exported arm. The test puts the prefix for `exported` and defines `WORDS`, the numbers of a
 * target; `GIVEN`, the argument of what is given beside it; `HAS_MOTOR` and so on, what else there is. Numbers are read and
 * printed as their bits in hexadecimal. */
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "exported.h"

typedef exported_real_t real;

static int number(real *x)
{
    uint64_t wide;
    uint32_t narrow;
    if (scanf("%" SCNx64, &wide) != 1)
        return 0;
    narrow = (uint32_t)wide;
    memcpy(x, sizeof *x == 4 ? (void *)&narrow : (void *)&wide, sizeof *x);
    return 1;
}

static int numbers(real *x, int count)
{
    int i;
    for (i = 0; i < count; i++)
        if (!number(&x[i]))
            return 0;
    return 1;
}

static void show(const real *x, int count)
{
    int i;
    for (i = 0; i < count; i++) {
        uint64_t wide = 0;
        uint32_t narrow = 0;
        if (x[i] != x[i]) {
            printf(" nan");
            continue;
        }
        memcpy(sizeof *x == 4 ? (void *)&narrow : (void *)&wide, &x[i], sizeof *x);
        printf(" %" PRIx64, sizeof *x == 4 ? narrow : wide);
    }
}

#ifdef EXPORTED_MAX_SOLUTIONS
static void solution(const exported_solution_t *s)
{
    show(s->q, EXPORTED_JOINTS);
    show(&s->position_residual, 1);
    show(&s->orientation_residual, 1);
    printf(" %u %u %u %u %u %u", s->flags, s->free_joints, s->branch.shoulder, s->branch.elbow, s->branch.wrist, s->branch.root);
}

static void solutions(int32_t status, const exported_solutions_t *all)
{
    int i;
    printf(" | %d %d", (int)status, (int)all->count);
    show(&all->gap, 1);
    show(&all->deviation, 1);
    for (i = 0; i < all->count; i++)
        solution(&all->items[i]);
}
#endif

static void motors(const real *q)
{
    (void)q;
#ifdef HAS_MOTOR
    {
        real motor[EXPORTED_JOINTS], back[EXPORTED_JOINTS];
        printf(" | %d", (int)exported_to_motor(q, motor));
        show(motor, EXPORTED_JOINTS);
        exported_from_motor(motor, back);
        show(back, EXPORTED_JOINTS);
    }
#endif
#ifdef HAS_PULSES
    {
        int32_t pulses[EXPORTED_JOINTS];
        uint16_t saturated;
        real back[EXPORTED_JOINTS];
        int i;
        printf(" | %d", (int)exported_to_pulses(q, pulses, &saturated));
        exported_to_pulses(q, pulses, NULL);
        for (i = 0; i < EXPORTED_JOINTS; i++)
            printf(" %d", (int)pulses[i]);
        printf(" %u", saturated);
        exported_from_pulses(pulses, back);
        show(back, EXPORTED_JOINTS);
    }
#endif
#ifdef HAS_ARM_ANGLE
    {
        real angle;
        printf(" | %d", (int)exported_arm_angle(q, &angle));
        show(&angle, 1);
    }
#endif
}

/* Bytes that no result has. */
#define UNTOUCHED 0xa5

static int untouched(const void *from, size_t count)
{
    const unsigned char *bytes = from;
    while (count > 0 && bytes[count - 1] == UNTOUCHED)
        count--;
    return count == 0;
}

/* Bad arguments, which have status 3 each and nothing written. */
static void arguments(void)
{
    static const real q[EXPORTED_JOINTS + 1];
    exported_pose_t pose;
    exported_jacobian_t jacobian[2];
    /* One byte out of line. */
    const real *bent = (const real *)(const void *)((const char *)q + 1);
    exported_jacobian_t *askew = (exported_jacobian_t *)(void *)((char *)jacobian + 1);
    memset(&pose, UNTOUCHED, sizeof pose);
    memset(jacobian, UNTOUCHED, sizeof jacobian);
    printf("arguments %d %d %d", exported_forward(NULL, &pose), exported_forward(q, NULL), exported_forward(bent, &pose));
    printf(" %d %d", exported_jacobian(q, NULL), exported_jacobian(q, askew));
    printf(" %d %d %d", exported_forward_and_jacobian(q, NULL, jacobian), exported_forward_and_jacobian(q, &pose, NULL),
        exported_forward_and_jacobian(q, &pose, askew));
    printf(" %d", untouched(&pose, sizeof pose) && untouched(jacobian, sizeof jacobian) ? 3 : 0);
#ifdef EXPORTED_MAX_SOLUTIONS
    {
        static const real words[WORDS], given;
        const void *target = words;
        exported_solutions_t all;
        void *place = &all;
        exported_solution_t one;
        real gap[2];
        real *askew_gap = (real *)(void *)((char *)gap + 1);
        exported_branch_t branch = {0, 0, 0, 0}, wrong = {3, 0, 0, 0};
        (void)given;
        memset(&all, UNTOUCHED, sizeof all);
        memset(&one, UNTOUCHED, sizeof one);
        memset(gap, UNTOUCHED, sizeof gap);
        printf(" %d %d", exported_inverse(NULL, GIVEN &all), exported_inverse(target, GIVEN NULL));
        printf(" %d %d %d", exported_inverse_near(NULL, q, &all), exported_inverse_near(target, NULL, &all),
            exported_inverse_near(target, q, NULL));
        printf(" %d %d %d %d", exported_inverse_branch(target, GIVEN NULL, &one, gap),
            exported_inverse_branch(target, GIVEN &branch, NULL, gap), exported_inverse_branch(target, GIVEN &wrong, &one, gap),
            exported_inverse_branch(target, GIVEN &branch, &one, askew_gap));
        printf(" %d %d", exported_target_at(NULL, place), exported_target_at(q, NULL));
        printf(" %d", untouched(&all, sizeof all) && untouched(&one, sizeof one) && untouched(gap, sizeof gap) ? 3 : 0);
    }
#endif
#ifdef HAS_PULSES
    {
        int32_t pulses[EXPORTED_JOINTS];
        uint16_t saturated[2];
        memset(pulses, UNTOUCHED, sizeof pulses);
        printf(" %d", exported_to_pulses(q, pulses, (uint16_t *)(void *)((char *)saturated + 1)));
        printf(" %d", untouched(pulses, sizeof pulses) ? 3 : 0);
    }
#endif
    printf("\n");
}

/* An output may be the memory of an input. */
static void in_place(const real *q)
{
    union {
        real q[EXPORTED_JOINTS];
        exported_pose_t pose;
    } place;
    exported_pose_t pose;
    memcpy(place.q, q, sizeof place.q);
    exported_forward(q, &pose);
    exported_forward(place.q, &place.pose);
    if (memcmp(&pose, &place.pose, sizeof pose) != 0)
        printf("in place: another pose");
}

int main(void)
{
    real q[EXPORTED_JOINTS];
    exported_pose_t pose;
    exported_jacobian_t jacobian;
    arguments();
    while (numbers(q, EXPORTED_JOINTS)) {
        printf("%d", (int)exported_forward(q, &pose));
        show(&pose.rotation[0][0], 12);
        printf(" | %d", (int)exported_jacobian(q, &jacobian));
        show(&jacobian.rows[0][0], 6 * EXPORTED_JOINTS);
        printf(" | %d", (int)exported_forward_and_jacobian(q, &pose, &jacobian));
        show(&pose.rotation[0][0], 12);
        show(&jacobian.rows[0][0], 6 * EXPORTED_JOINTS);
#ifdef EXPORTED_MAX_SOLUTIONS
        {
            real words[WORDS], given, q_ref[EXPORTED_JOINTS], gap;
            const void *target = words;
            void *target_at = words;
            unsigned parts[4];
            exported_solutions_t all;
            exported_solution_t one;
            exported_branch_t branch;
            if (!numbers(words, WORDS) || !number(&given) || !numbers(q_ref, EXPORTED_JOINTS))
                return 1;
            if (scanf("%u %u %u %u", &parts[0], &parts[1], &parts[2], &parts[3]) != 4)
                return 1;
            branch.shoulder = (uint8_t)parts[0];
            branch.elbow = (uint8_t)parts[1];
            branch.wrist = (uint8_t)parts[2];
            branch.root = (uint8_t)parts[3];
            solutions(exported_inverse(target, GIVEN &all), &all);
            solutions(exported_inverse_near(target, q_ref, &all), &all);
            printf(" | %d", (int)exported_inverse_branch(target, GIVEN &branch, &one, &gap));
            show(&gap, 1);
            solution(&one);
            printf(" | %d", (int)exported_target_at(q, target_at));
            show(words, WORDS);
        }
#endif
        motors(q);
        in_place(q);
        printf("\n");
    }
    return 0;
}
