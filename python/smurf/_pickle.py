# SPDX-License-Identifier: BSD-3-Clause
"""What pickles of models and scenes call."""


def load(name, source, settings):
    """Loads again what one of the functions of the module has loaded."""
    import smurf
    return getattr(smurf, name)(source, **settings)


def part(whole, name, index):
    """An element of one of the lists of a model or scene."""
    return getattr(whole, name)[index]
