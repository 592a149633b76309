"""From the pose back to the joints: every joint vector that reaches a pose, by one method for all serial arms.

A *plan* is found once for a robot: which joints can be read off which equation, in which order. It is then run on
numbers, for one pose or for many at once. The loop `E_1(q1) ... E_n(qn) = G` (E_i the motion of joint i about its axis
in the zero pose, G the pose asked for times the inverse of the zero pose) is cut in two places, and both halves are
applied to things that a run of joints leaves fixed: a direction, a point, a line, a circle. Each pairing is an
equation in the joints that are left, linear in the cosine and sine of each.
"""
