# %% [markdown]
# ## Sets that the map carries over one another: chaos, proven
# Every path from set to set is some orbit's itinerary, so that the paths' entropy is a lower bound of the map's.
# %%
with h5py.File(path) as file:
    chaos = dict(file["chaos"].attrs)
sets, coverings = group("sets"), group("coverings")
start, end = (coverings[name].values.astype(int) - 1 for name in ("from", "to"))
transitions = np.zeros((sets.sizes["set"],) * 2)
transitions[start, end] = 1
radius = abs(np.linalg.eigvals(transitions)).max()
print(f"{len(transitions)} sets, {len(start)} times one is carried over another: the paths' entropy is {np.log(radius):.6f}, "
      f"{chaos['entropy']:.6f} of it proven; largest exponent of an orbit {chaos['exponent']:.4f}, not proven")
# %%
names = [name for name in sets.data_vars if name.startswith("centre_")]
first, last = names[0], names[-1]
figure, (left, right) = plt.subplots(1, 2, figsize=(9, 4.2), layout="constrained")
for a, b in zip(start, end):
    x, y = (sets[name].values[[a, b]] for name in (first, last))
    if abs(x[1] - x[0]) < np.pi:
        left.plot(x, y, "-", color="0.7", lw=0.5)
left.plot(sets[first], sets[last], "k.", ms=4)
left.set(xlabel=first.removeprefix("centre_"), ylabel=last.removeprefix("centre_"))
carried = group("carried").to_dataframe()
middle = np.bincount(end).argmax()
for number in np.flatnonzero(end == middle):
    for side in (-1, 1):
        way = carried[(carried["covering"] == number + 1) & (carried["side"] == side)]
        right.plot(way["carried_q"], way["carried_side"], lw=0.8, color=f"C{number % 10}")
right.add_patch(plt.Rectangle((-1, -1), 2, 2, fill=False))
right.set(xlim=(-1.6, 1.6), ylim=(-1.25, 1.25), xlabel="along the edge that the map stretches", ylabel="along the second edge");
# %% [markdown]
# ## Is the record consistent?
# A v ≥ growth v for the weights v and the transitions A, both ends of each set that is carried lie beyond the other's,
# on different sides, and between them it leaves by no other side.
# %%
weights = sets["weight"].values
assert chaos["growth"] <= radius * (1 + 1e-12)
assert (transitions @ weights >= chaos["growth"] * weights * (1 - 1e-12)).all()
assert abs(np.exp(chaos["entropy"]) - chaos["growth"]) < 1e-9
for number in range(len(start)):
    of_it = carried[carried["covering"] == number + 1]
    low, high = (of_it[of_it["q"] == q]["carried_q"] for q in (-1, 1))
    assert (low * high.values < 0).all() and (abs(low) > 1).all() and (abs(high) > 1).all()
    within = abs(of_it["carried_q"]) <= 1
    assert (abs(of_it["carried_side"][within]) < 1).all()
