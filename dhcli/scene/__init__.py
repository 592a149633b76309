"""What a figure shows: a robot at a pose, or a linkage, as solids, frames and dimensions in space, and on paper.

A Scene holds primitives whose points are anchored to the states of the chain of moves; a Camera puts them on paper,
the painter orders them from back to front, and the placer finds room for the labels. Nothing here knows a file format.
"""
