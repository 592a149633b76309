"""Text to expression and back: tokens, parser, the n-ary tree, exact angles, matrices, and the one writer.

Nothing here evaluates text as code. What a robot is, or what a chain of moves means, is not known in this room.
"""
