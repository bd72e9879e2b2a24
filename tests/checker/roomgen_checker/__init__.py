"""An independent check of furnished rooms.

Written from docs/constraints.md and the file formats alone, with other methods than the solver
(exact polygons instead of tests on boxes, a distance transform instead of a walk over a grid), so
that an error in one of the two shows up as a disagreement.
"""
