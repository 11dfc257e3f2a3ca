"""The lab as a study sees it that runs with an explicit scheme."""

from _lab import Lab


class SchemeLab(Lab):
    """Adds the scheme, corrected masses, full quadrature and a row for every step to the settings of every run that do
    not say otherwise. What is asked stays here; runs, commands and files of cases belong to the whole."""

    prefix = "schemes_"
    MOMENTS = {"kick_drift": 0.02, "rkl2": 0.5, "ssp_rk3": 0.02}

    def __init__(self, whole, study, scheme):
        super().__init__(study, whole.store, whole.folder, True, whole.jobs)
        self.scheme = scheme
        self.moment = self.MOMENTS[scheme]  # a time of tens to hundreds of steps over a thin vapour, 64 elements to a length
        self.texts, self.files, self.commands, self.seconds = whole.texts, whole.files, whole.commands, whole.seconds

    def get(self, label, case, settings=(), *others, **keywords):
        words = list(settings)
        for key, value in (("time.scheme", self.scheme), ("time.mass", "corrected"), ("domain.quadrature", "full"),
                           ("output.history.every", "1")):
            if not any(word.startswith(f"{key}=") for word in settings):
                words.append(f"{key}={value}")
        return super().get(f"{self.name}, {self.scheme}: {label}", case, words, *others, **keywords)

    def table(self, columns, rows, name=None):
        """Tables belong to the study itself; here only what is asked counts."""

    def plot(self, name, draw, shown=True):
        """Pictures belong to the study itself."""
