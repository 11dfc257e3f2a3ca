"""The one exception of the package."""


class Problem(Exception):
    """Something in the files or in what was asked for is wrong; the text is a sentence for the user."""
