"""How many ways a linkage can move: the formula with its counts, and the truth from its geometry.

Counting (`pairs`, `linkage`, `counting`, `patterns`, `slips`) is exact arithmetic without numpy. Geometry follows the
steps of one method: `model` (unit twists, spanning tree), `loops` (λ of each loop), `rank`, `idle`, `second_order`,
`landing` (imposed amplitude), `reasons`; `constraints` is the form for long chains; `finding` puts them in order.
"""
