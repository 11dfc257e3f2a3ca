# ---
# jupyter:
#   jupytext:
#     text_representation:
#       format_name: percent
#   kernelspec:
#     display_name: Python 3
#     language: python
#     name: python3
# ---

# %% [markdown]
# # A sweep over stiffness
#
# A droplet pulls a ridge out of a soft layer. This notebook computes the ridge for four values of Young's modulus,
# makes a table of the results, and compares it with the scaling of linear elasticity, in which the ridge is inversely
# proportional to the modulus.
#
# It needs the package `softwet` with its program ([python.md](../python.md)), pandas and matplotlib.
# `jupytext --to notebook` makes an `.ipynb` of this file, and Jupyter with jupytext opens it as it is. The mesh is
# coarse, so that each run takes a second.

# %%
import matplotlib.pyplot as plt
import pandas

import softwet

# %% [markdown]
# ## The case
#
# A case is a dict. `softwet.Case` checks it and fills in every default.

# %%
case = softwet.Case({
    "name": "ridge",
    "domain": {"size": [1.0, 0.5], "elements": [40, 20]},
    "fluid": {"viscosity": 0.05, "capillarity": 0.05, "temperature": 0.39, "contact_angle": 90},
    "substrate": {"thickness": 0.125, "young": 1.0, "poisson": 0.45},
    "droplet": [{"centre": [0.5, 0.125], "radius": 0.25}],
    "time": {"end": 4.0},
})
print(case["time"]["dt_max"], case["boundary"]["bottom"])

# %% [markdown]
# ## The sweep
#
# One call computes all members, two at a time. The same call again computes only what is missing.

# %%
swept = softwet.sweep(case, {"substrate.young": [1, 2, 4, 8]}, out="out/ridge_sweep", jobs=2, threads=1,
                      columns=["ridge_left", "ridge_right", "dimple"], progress=False)
table = pandas.DataFrame(swept.table)
table = table[["substrate.young", "status", "ridge_left", "ridge_right", "dimple", "seconds"]]
print(table)

# %% [markdown]
# ## The results
#
# The product of ridge and modulus is nearly the same for stiff layers. On the softest layer the slopes of the wall are
# large, and the law is less exact.

# %%
table["ridge times young"] = table["ridge_right"] * table["substrate.young"]
print(table[["substrate.young", "ridge times young"]])

# %%
figure, (left, right) = plt.subplots(1, 2, figsize=(8, 3), layout="constrained")
left.loglog(table["substrate.young"], table["ridge_right"], "o-", label="computed")
left.loglog(table["substrate.young"], table["ridge_right"].iloc[-1] * 8 / table["substrate.young"], "k--", label="slope -1")
left.set(xlabel=r"Young's modulus $/\;\rho_0^s\,a b$", ylabel="ridge $/\;L_0$", xticks=table["substrate.young"])
left.set_xticklabels(f"{young:g}" for young in table["substrate.young"])
left.minorticks_off()
left.legend(frameon=False)
for member in swept:
    history = pandas.DataFrame(member.run.history)
    right.plot(history["t"], history["ridge_right"], label=f"E = {member.values['substrate.young']:g}")
right.set(xlabel=r"$t \;/\; L_0\,(ab)^{-1/2}$", ylabel="ridge $/\;L_0$")
right.legend(frameon=False)
figure.savefig("out/ridge_sweep/ridge.png", dpi=150)
