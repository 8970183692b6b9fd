/* Both arms reach the pose of their own joint vector, in C and in C++. */
#include "anthro3r.h"
#include "abb_irb140.h"

static int first(void)
{
    float q[ANTHRO3R_JOINTS] = {0.3f, 0.4f, 0.5f};
    anthro3r_pose_t pose;
    anthro3r_solutions_t found;
    if (anthro3r_forward(q, &pose) != ANTHRO3R_OK)
        return 1;
    if (anthro3r_inverse(pose.translation, &found) != ANTHRO3R_OK)
        return 2;
    return found.count == 4 ? 0 : 3;
}

static int second(void)
{
    double q[ABB_IRB140_JOINTS] = {0.1, 0.2, 0.3, 0.4, 0.5, 0.6};
    abb_irb140_pose_t pose;
    abb_irb140_solutions_t found;
    if (abb_irb140_forward(q, &pose) != ABB_IRB140_OK)
        return 10;
    if (abb_irb140_inverse(&pose, &found) != ABB_IRB140_OK)
        return 20;
    return found.count == 8 && found.reserved == 0 ? 0 : 30;
}

int main(void)
{
    return first() + second();
}
