"""Runs that are kept in a folder: members and how they ended, their computation, and what the folder was made for."""
