"""Programs that a tool starts, and how it is asked to stop."""

import signal
import subprocess


def start(words, log, **options):
    """Starts a program that says all to a file, in a session of its own: Ctrl-C reaches the tool alone, which passes it on.
    @param options  of subprocess.Popen, in place of these"""
    usual = {"stdin": subprocess.DEVNULL, "stdout": log, "stderr": log, "start_new_session": True}
    return subprocess.Popen(words, **{**usual, **options})


def when_asked_to_stop(action):
    """What Ctrl-C, SIGTERM and a closed terminal do from now on; those that are ignored (nohup) stay so."""
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        if signal.getsignal(number) is not signal.SIG_IGN:
            signal.signal(number, action)


def end_when_asked():
    """Until runs are under way, a wish to stop ends the tool as Ctrl-C does."""
    def stop(*_):
        raise KeyboardInterrupt

    when_asked_to_stop(stop)
