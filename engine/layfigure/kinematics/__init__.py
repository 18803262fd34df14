"""Swing-twist joints and forward kinematics: from angles to where every limb stands."""
