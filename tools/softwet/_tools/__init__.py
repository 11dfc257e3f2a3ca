"""What every tool begins with: the choice of the interpreter, and how a tool speaks to its user."""
