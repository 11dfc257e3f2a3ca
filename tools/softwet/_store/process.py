"""Programs that a tool starts, and how it is asked to stop."""

import signal
import subprocess
import sys

from .._tools.messages import fail_of_machine
from .._tools.python import end_unread


def start(words, log, **options):
    """Starts a program that says all to a file, in a session of its own: Ctrl-C reaches the tool alone, which passes it
    on.
    @param options  of subprocess.Popen, in place of these"""
    usual = {"stdin": subprocess.DEVNULL, "stdout": log, "stderr": log, "start_new_session": True}
    return subprocess.Popen(words, **{**usual, **options})


def when_asked_to_stop(action):
    """What Ctrl-C, SIGTERM and a closed terminal do from now on; those that are ignored (nohup) stay so."""
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        if signal.getsignal(number) is not signal.SIG_IGN:
            signal.signal(number, action)


def carry_out(main, interrupted):
    """Runs a tool to its end, with a sentence for what ends it early. Until runs are under way, a wish to stop ends it
    as Ctrl-C does. @param main  gives the exit code;  @param interrupted  called where it was asked to stop"""
    def stop(*_):
        raise KeyboardInterrupt

    when_asked_to_stop(stop)
    try:
        code = main()
        sys.stdout.flush()
        raise SystemExit(code)
    except BrokenPipeError:
        end_unread()
    except KeyboardInterrupt:
        interrupted()
    except OSError as error:
        fail_of_machine(error)
