"""Films: pictures one after the other, written as whatever the name of the output asks for.

A :class:`~layfigure_frontends.film.reel.Film` can draw its pictures; a sink takes them one by one, so that a long film
needs no more memory than a short one; :mod:`layfigure_frontends.film.production` brings both and the cache together.
"""
