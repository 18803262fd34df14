"""Hyper-tessellations: the same space cut ever finer, level by level, so that a search can go from coarse to fine."""
