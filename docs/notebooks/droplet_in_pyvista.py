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
# # A droplet in PyVista
#
# softwet writes its fields as VTKHDF, the format of VTK and ParaView. This notebook computes a droplet on a soft layer
# in 3D, on a mesh so coarse that it takes seconds, and reads the files in two ways: with VTK's own reader, as ParaView
# does, and with the package `softwet`. It needs PyVista (`pip install pyvista`). ParaView opens
# `fields/fluid.hdf.series` and shows the same.

# %%
import pyvista

import softwet

# %%
run = softwet.run({
    "name": "droplet",
    "domain": {"size": [0.8, 0.8, 0.4], "elements": [8, 8, 4]},
    "fluid": {"viscosity": 0.05, "capillarity": 0.15, "temperature": 0.39, "contact_angle": 75},
    "solver": {"krylov": {"preconditioner": "lu"}},
    "substrate": {"thickness": 0.1, "young": 0.7554, "poisson": 0.45},
    "droplet": [{"centre": [0.4, 0.4, 0.1], "radius": 0.3}],
    "time": {"end": 0.1},
    "output": {"fields": {"times": [0.0, 0.1]}},
}, out="out/droplet_3d", threads=1, progress=False, overwrite=True)
print(run.state, run.times)

# %% [markdown]
# ## The files, as ParaView reads them
#
# The points lie at their deformed positions, so no filter is needed to warp them.

# %%
fluid = pyvista.read(run.folder / "fields" / "fluid_0001.hdf")
solid = pyvista.read(run.folder / "fields" / "solid_0001.hdf")
print(fluid.n_points, sorted(fluid.point_data), fluid.bounds)

# %% [markdown]
# ## The surface of the droplet
#
# It lies where the density is halfway between vapour and liquid.

# %%
phases = run.record["equilibrium"]
middle = 0.5 * (phases["density_vapour"] + phases["density_liquid"])
surface = fluid.contour([middle], scalars="density")
print("area of the surface:", surface.area, " height:", surface.bounds[5] - 0.1)

# %%
plotter = pyvista.Plotter(off_screen=True)
plotter.add_mesh(solid, scalars="displacement", component=2, cmap="PuOr_r", scalar_bar_args={"title": "vertical displacement / L0"})
plotter.add_mesh(surface, color=(0.36, 0.62, 0.86), opacity=0.7, smooth_shading=True)
plotter.camera_position = [(1.6, -0.9, 0.9), (0.4, 0.4, 0.1), (0, 0, 1)]
plotter.screenshot("out/droplet_3d/droplet.png")

# %% [markdown]
# ## The same from the package
#
# `to_pyvista` gives the grid of a part of the scene, with the fields that are named. Here the wall is cut along the
# middle.

# %%
grid = run.fields(0.1, "solid").to_pyvista("displacement")
profile = grid.slice(normal="y", origin=(0.4, 0.4, 0.05))
print("highest and lowest point of the wall:", profile.points[:, 2].max(), grid.points[-17 * 17:, 2].min())
