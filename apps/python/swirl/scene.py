"""The scene: a body in a swirled container, and its collision map."""

import os
import reprlib
import types

from . import _swirl

#: The parameters, by the names of the command's flags with _ for -.
NAMES = tuple(name.replace("-", "_") for name in _swirl.scene_names())


def text_of(value):
    """A number or a word as a flag has it: the shortest decimal that reads back to the same number."""
    if isinstance(value, str):
        return value
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if isinstance(value, bool):
        raise ValueError(f"{value} is no number")
    if isinstance(value, int):
        return str(value)
    if isinstance(value, float):
        return float.__repr__(value)
    try:
        if hasattr(value, "__index__"):  # NumPy's whole numbers
            return str(value.__index__())
    except TypeError:  # an array has it, too
        pass
    if hasattr(value, "__float__") and not getattr(value, "ndim", 0):
        return float.__repr__(float(value))
    raise ValueError(f"{reprlib.repr(value)} is neither a number nor a word")


def text_of_argument(name, value):
    """The same, of an argument whose name a refusal says."""
    try:
        return text_of(value)
    except ValueError as error:
        raise ValueError(f"{name}: {error}") from None


def _value(name, doc, otherwise=None):
    """One of a scene's values as a property."""
    return property(lambda scene: scene._values.get(name, otherwise), doc=doc)


class Scene:
    """A regular polygon or disk in a swirled circular container, with restitution and Coulomb friction.

    A value: it cannot be changed, is equal to another scene whose numbers are the same doubles and whose units are the
    same, however they were given, and can be hashed and pickled.

    Parameters
    ----------
    sides : int or "disk"
        N, 2 (a rod) to 1000000.
    alpha : float
        R_p/R_c, the body's circumradius over the container's radius, 0 < alpha < 1.
    beta : float
        r_s/R_c, the radius of the swirl's circle over the container's, 0 or more.
    mu : float
        Coefficient of friction, 0 or more.
    restitution : float
        Coefficient of restitution e, 0 to 1.
    law : {"poisson", "newton", "stronge"}
        Where restitution ends.
    inertia_factor : float, optional
        kappa, I = kappa m R_p**2; by default the uniform lamina's.
    corner : float, optional
        r/R_c, the radius of a polygon's rounded corners, 0 <= r < alpha; 0 by default. r = alpha is the disk.
    container_radius, swirl_radius, polygon_radius, corner_radius : float, optional
        R_c, r_s, R_p and r in m; with any of these six all that functions take and records hold is in m, s and kg.
    swirl_rate : float, optional
        omega_s in rad/s.
    mass : float, optional
        m in kg.
    drag, spin_drag : float, optional
        gamma and gamma_r of a floor that drags, in omega_s: force -gamma (V - V_floor), torque -gamma_r I S; 0, and as `drag`,
        by default.
    floor_friction, gravity_ratio : float, optional
        M and G = g/(R_c omega_s**2) of a floor with dry friction: force -M m g <u/|u|>, the mean over the body; 0 by default. G
        is that of 9.80665 m/s**2 where R_c and omega_s are given and it is not.
    floor : {"dish", "table"}, optional
        Whether that floor moves with the container (the default) or is at rest.
    tangential_restitution : float, optional
        e_t of a disk, 0 to 1: an impact that sticks returns u_t+ = -e_t u_t-; 0 by default. A polygon's is 0.

    Raises
    ------
    ValueError
        For what is missing or out of range, with the line that the command says.

    Notes
    -----
    A number may be given as text, which `accuracy="quad"` then reads in 113 bits.
    """

    __slots__ = ("_texts", "_scene", "_values")

    def __init__(self, sides=None, alpha=None, beta=None, mu=None, restitution=None, law="poisson", inertia_factor=None,
                 *, container_radius=None, swirl_radius=None, swirl_rate=None, polygon_radius=None, mass=None,
                 drag=None, spin_drag=None, floor=None, tangential_restitution=None, corner=None, corner_radius=None,
                 floor_friction=None, gravity_ratio=None):
        given = {name: value for name, value in locals().items() if name != "self"}
        self._read([f"--{name.replace('_', '-')}={text_of_argument(name, value)}"
                    for name, value in given.items() if value is not None])

    def _read(self, words):
        scene = _swirl.Scene(words)
        values = types.MappingProxyType(scene.values())
        for name, value in zip(self.__slots__, (tuple(sorted(scene.texts().items())), scene, values)):
            object.__setattr__(self, name, value)

    @classmethod
    def from_units(cls, **parameters):
        """A scene in physical units: `container_radius` (m), `swirl_radius` (m), `polygon_radius` (m), `swirl_rate`
        (rad/s), `mass` (kg), beside `sides`, `mu`, `restitution`, `law` and `inertia_factor`."""
        if parameters.get("container_radius") is None:
            raise ValueError("container_radius is missing: R_c in m")
        return cls(**parameters)

    @classmethod
    def from_toml(cls, path):
        """The scene under [scene] of a TOML file with the same names as keys. (Its [start], if it has one, is read where
        the file itself is given to a function: `scene=path`.)"""
        scene = cls.__new__(cls)
        scene._read([f"--scene={os.fspath(path)}"])
        return scene

    @classmethod
    def from_record(cls, path):
        """The scene of a record, or of a result."""
        scene = cls.__new__(cls)
        texts = _swirl.scene_of_record(os.fspath(path))
        scene._read([f"--{name}={text}" for name, text in texts.items()])
        return scene

    sides = _value("sides", 'N, or "disk".')
    alpha = _value("alpha", "R_p/R_c.")
    beta = _value("beta", "r_s/R_c.")
    mu = _value("mu", "Coefficient of friction.")
    restitution = _value("restitution", "Coefficient of restitution.")
    law = _value("law", "The impact law's name.")
    inertia_factor = _value("inertia_factor", "kappa, I = kappa m R_p**2.")
    drag = _value("drag", "gamma, in omega_s.", 0.0)
    spin_drag = _value("spin_drag", "gamma_r, in omega_s.", 0.0)
    floor_friction = _value("floor_friction", "M of the floor's dry friction.", 0.0)
    gravity_ratio = _value("gravity_ratio", "g/(R_c omega_s**2), of a floor with dry friction.", 0.0)
    floor = _value("floor", "`dish` or `table`; None of a floor that does not act.")
    tangential_restitution = _value("tangential_restitution", "e_t of the disk.", 0.0)
    corner = _value("corner", "r/R_c, the radius of rounded corners.", 0.0)

    @property
    def units(self):
        """{"length", "time", "mass"} in m, s and kg; None of a scene without units."""
        return self._values["units"] and dict(self._values["units"])

    @property
    def dimension(self):
        """Coordinates of the section: 5 (psi, chi, vn, vt, S), of a disk 4 (psi, vn, vt, S)."""
        return 4 if self.sides == "disk" else 5

    @property
    def flags(self):
        """What the command is given for this scene, by the names of its flags."""
        return dict(self._texts)

    def map(self, z, steps=1, threads=0, outcomes=False):
        """The collision map F: from just after an impact to just after the next, through sustained contact.

        Parameters
        ----------
        z : array_like, shape (d,) or (n, d)
            States just after an impact, d = 5: psi and chi in rad, vn and vt in R_c omega_s, S in omega_s; a disk's
            d = 4, without chi. (Of a scene with units, too.)
        steps : int
            How many times F is applied. States stay the map's own in between: F applied twice to rounded coordinates
            differs by rounding from `steps=2`, which is what `simulate` iterates.
        threads : int
            0: all. Results do not depend on it.
        outcomes : bool
            Also say how each row ended.

        Returns
        -------
        image : ndarray, shape of z
            NaN where there is no such impact.
        outcome : ndarray of int8, shape (n,); a word of one state
            With `outcomes=True`. Codes are places in `swirl.Scene.OUTCOMES`: "completed", "no-contact", "in-contact",
            "contact-cut-short", "resting", "diverged", "unresolved", "not-leaving" of what is no state just after an
            impact (u_n > 0, or a vertex outside), of a floor that drags "riding", of rounded corners "contact-of-corner".

        Notes
        -----
        Rows advance together, one a lane of the processor's vectors, on several threads, and give what each gives alone,
        bit for bit. Source: map/README.md and map/batch/README.md.
        """
        try:
            if not outcomes:
                return self._scene.map(z, steps, threads)
            return self._named(self._scene.map(z, steps, threads, True), 1)
        except TypeError:
            raise _unfit(z, steps=steps, threads=threads) from None

    def derivative(self, z, threads=0, outcomes=False):
        """DF, exact (no differences), through sustained contact too.

        Parameters
        ----------
        z, threads, outcomes
            As of `map`.

        Returns
        -------
        derivative : ndarray, shape (d, d) or (n, d, d)
            d F_i / d z_j at [..., i, j]; NaN where there is no next impact.
        outcome
            As of `map`, with `outcomes=True`.

        Notes
        -----
        The saltation of flight and impact, in closed form: map/README.md, "Derivative".
        """
        try:
            if not outcomes:
                return self._scene.derivative(z, threads)
            return self._named(self._scene.derivative(z, threads, True), 2)
        except TypeError:
            raise _unfit(z, threads=threads) from None

    @classmethod
    def _named(cls, found, one):
        values, codes = found
        return values, cls.OUTCOMES[codes[0]] if values.ndim == one else codes

    #: What codes of outcomes mean.
    OUTCOMES = tuple(_swirl.outcomes)

    def __setattr__(self, name, *_):
        raise AttributeError(f"{name}: a Scene cannot be changed; scene.with_(alpha=…) makes another")

    __delattr__ = __setattr__

    def with_(self, **parameters):
        """The scene with other values of some parameters."""
        texts = {name.replace("-", "_"): text for name, text in self._texts}
        for name, other in (("alpha", "polygon_radius"), ("beta", "swirl_radius"), ("corner", "corner_radius")):
            for given, replaced in ((name, other), (other, name)):
                if parameters.get(given) is not None:
                    texts.pop(replaced, None)
        return type(self)(**{**texts, **parameters})

    @property
    def _numbers(self):
        """What it comes to: kappa is the uniform lamina's, whether it was given or not."""
        units = self._values["units"]
        return (*((name, value) for name, value in self._values.items() if name != "units"), units and tuple(units.items()))

    def __eq__(self, other):
        return self._numbers == other._numbers if isinstance(other, Scene) else NotImplemented

    def __hash__(self):
        return hash(self._numbers)

    def __reduce__(self):
        return _scene_from, (self._texts,)

    def __repr__(self):
        def shown(name, text):
            return f"{name.replace('-', '_')}={text if _is_value(text) else repr(text)}"
        texts = dict(self._texts)
        named = [name.replace("_", "-") for name in NAMES]
        return f"Scene({', '.join(shown(name, texts[name]) for name in named if name in texts)})"


def _unfit(z, **whole):
    """Why these are no arguments of a map."""
    for name, value in whole.items():
        if not hasattr(value, "__index__"):
            return TypeError(f"{name} = {value!r} is no whole number")
    import numpy
    try:
        numpy.asarray(z, dtype=float)
    except (TypeError, ValueError) as error:
        return ValueError(f"z = {reprlib.repr(z)} is no array of numbers: {error}")
    return TypeError(f"z = {reprlib.repr(z)} is no array of numbers")


def _is_value(text):
    """Would Python's number of that text be written so again?"""
    try:
        return repr(float(text)) == text or str(int(text)) == text
    except ValueError:
        return False


def _scene_from(texts):
    scene = Scene.__new__(Scene)
    scene._read([f"--{name}={text}" for name, text in texts])
    return scene
