# %% [markdown]
# # From measured data to a verdict
# **The data here are synthetic**: the angle of a simulated hexagon, at 30 pictures a second for half a minute of a swirl of
# one turn a second, with 0.2° of noise added, and wrapped to 0 … 360°, as a camera's tracker writes it. The way from the
# file to the verdict is that of a real film.
#
# The orbit, after it has settled, and the film:
# %% [commands]
# swirl simulate --sides 6 --alpha 0.635 --beta 0.5 --mu 0.5 --restitution 0.95 \
#     --time 2200 --sample 0.20943951023931953 -o orbit.h5
# %% [made]
# import h5py, numpy
# with h5py.File("orbit.h5") as record:
#     t, angle = record["samples/t"][:], record["samples/angle"][:]
# angle = angle[t > 2000][:900]
# noisy = numpy.degrees(angle) + numpy.random.default_rng(1).normal(0, 0.2, len(angle))
# with open("film.csv", "w") as file:
#     file.write("seconds,degrees\n")
#     for picture, value in enumerate(noisy % 360):
#         file.write(f"{picture / 30:.4f},{value:.2f}\n")
# %% [commands]
# swirl classify --series film.csv --time seconds --angle degrees --degrees --swirl-rate 6.283185307179586 -o verdict.h5
# swirl spectrum --series film.csv --time seconds --angle degrees --degrees --swirl-rate 6.283185307179586 -o spectrum.h5
# %% [files]
# film.csv verdict.h5 spectrum.h5
# %%
import csv, h5py, matplotlib.pyplot as plt, numpy as np

with open(folder / "film.csv") as file:
    rows = list(csv.DictReader(file))
seconds, degrees = (np.array([float(row[name]) for row in rows]) for name in ("seconds", "degrees"))
print(f"{len(rows)} pictures in {seconds[-1]:.1f} s; the first angles: {degrees[:4]}")
# %% [markdown]
# ## S from the angle
# The body turns by less than half a turn from picture to picture, so the angle can be unwound; its rate over that of the
# swirl, 2π a second, is S. Noise of 0.2° in the angle is 0.02 in S.
# %%
angle = np.unwrap(np.radians(degrees))
S = np.diff(angle) / np.diff(seconds) / (2 * np.pi)
turn = abs(np.diff(angle)).max() / np.pi
print(f"largest turn from picture to picture: {turn:.2f} of a half")
print(f"mean S: {(angle[-1] - angle[0]) / (seconds[-1] - seconds[0]) / (2 * np.pi):.3f}")
assert turn < 1
figure, axes = plt.subplots(figsize=(8, 2.8), layout="constrained")
axes.plot(seconds[1:151], S[:150], lw=0.8)
axes.set(xlabel="time, in seconds", ylabel="$S$");
# %% [markdown]
# ## Its spectrum
# %%
with h5py.File(folder / "spectrum.h5") as file:
    f, power = file["spectrum/frequency"][:], file["spectrum/power"][:]
    peaks = file["peaks/frequency"][:], file["peaks/power"][:]
figure, axes = plt.subplots(figsize=(8, 2.8), layout="constrained")
axes.semilogy(f[1:], power[1:], lw=0.8)
axes.set(xlabel="frequency, in cycles a second", ylabel="power of S")
strongest = peaks[0][np.argmax(peaks[1])]
print(f"strongest line at {strongest:.2f} cycles a second")
# %% [markdown]
# ## The verdict
# %%
with h5py.File(folder / "verdict.h5") as file:
    verdict = dict(file["mode"].attrs)
    evidence = [(name.decode(), value, says.decode()) for name, value, says in
                zip(file["mode/evidence"][:], file["mode/value"][:], file["mode/says"][:])]
print(f"mode: {verdict['mode']}; kind: {verdict['kind'] or 'none'}")
for name, value, says in evidence:
    print(f"  {name} = {value:.3g}: {says}")
assert verdict["mode"] == "quasi-steady"  # which the orbit is: a cycle of eight impacts
