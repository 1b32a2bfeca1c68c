"""Valid files of every kind of text that the program reads, from which mutations start."""

from __future__ import annotations

from viscoroll.case import example_text

__all__ = [
    "BESIDE_CASES",
    "CASES",
    "CURVES",
    "DESIGNS",
    "FACTORS",
    "MATERIALS",
    "MEASURED",
    "MOTIONS",
    "MOTION_TABLES",
    "RHEOLOGY",
    "STRAIN_SWEEPS",
    "STUDIES",
    "SURFACES",
]

_ROLLING = "[rolling]\nload = 50.0\nangular_speed = 2.5\n"
_BALL = "[ball]\ncore_radius = 20e-3\n[[ball.layers]]\nthickness = 2e-3\npoisson_ratio = 0.45\n"

_MASTER_CURVE = """
shear_modulus = { type = "master_curve", frequency = [0.0, 1.0, 1e5], storage = [1e6, 2e6, 5e6], loss = [0.0, 1e5, 1e5] }
"""  # noqa: E501
_SOFTENING = """
[ball.layers.shear_modulus]
type = "softening"
matrix = { type = "prony", instantaneous_modulus = 4e6, weights = [0.3, 0.2], relaxation_times = [0.1, 1.0] }
network = { type = "strain_sweep", file = "sweep.csv", kind = "shear" }
"""
_THERMAL = """
[thermal]
convection = 10.0
ambient = 293.15
conductivity = [0.2]
core = "isothermal"
shift = { type = "arrhenius", activation_energy = 60e3, reference_temperature = 293.15 }
"""
_PAIR = """
[wheel]
core_radius = 30e-3
width = 20e-3
crown_radius = 0.3
[[wheel.layers]]
thickness = 5e-3
poisson_ratio = 0.45
shear_modulus = { type = "fractional_zener", instantaneous_modulus = 6e6, relaxed_modulus = 3e6, relaxation_time = 0.1, order = 0.5 }
[plane]
[[plane.layers]]
thickness = 2e-3
bulk_modulus = 1e9
shear_modulus = { type = "kelvin_voigt", modulus = 3e6, viscosity = 1e3 }
[numerics]
nodes_per_revolution = 300
max_order = 400
"""  # noqa: E501
_MEASURED_MATERIAL = """
shear_modulus = { type = "measured", file = "rubber.toml", temperature = 303.15, form = "prony", draw = 1 }
"""

_MATERIAL = """# Shear moduli measured, as viscoroll reads them.
source = "made.txt"
reference_temperature = 293.15

[table]
frequency = [0.0, 0.1, 1.0, 10.0, 1000.0]
storage = [1e6, 1.1e6, 1.5e6, 2e6, 3e6]
loss = [0.0, 1e5, 2e5, 3e5, 2e5]

[prony]
instantaneous_modulus = 3.0e6
weights = [0.3, 0.2]
relaxation_times = [0.1, 1.0]

[draws]
instantaneous_modulus = [3.0e6, 3.1e6]
weights = [
    [0.3, 0.2],
    [0.31, 0.19],
]
relaxation_times = [
    [0.1, 1.0],
    [0.1, 1.0],
]
log10_factor = [
    [0.0, -0.5, -1.0],
    [0.0, -0.52, -1.1],
]

[shift]
temperature = [293.15, 303.15, 313.15]
log10_factor = [0.0, -0.5, -1.0]
"""

CURVES = (b"frequency,storage,loss\n0.0,1e6,0.0\n1.0,2e6,1e5\n100.0,5e6,1e5\n",)
_STRAINS = b"strain,storage,loss\n1e-3,5e6,4e5\n1e-2,4e6,6e5\n1e-1,2e6,4e5\n0.5,1e6,1e5\n"

#: Files that the cases refer to.
BESIDE_CASES = {"rubber.toml": _MATERIAL.encode(), "curve.csv": CURVES[0], "sweep.csv": _STRAINS}

CASES = tuple(
    text.encode()
    for text in (
        example_text(),
        _BALL + _MASTER_CURVE + _ROLLING + _THERMAL,
        _BALL + 'shear_modulus = { type = "master_curve", file = "curve.csv", extrapolation = "hold" }\n' + _ROLLING,
        _BALL + _SOFTENING + _ROLLING + "friction = 0.3\ndrive = { torque = 0.0 }\n",
        _PAIR + _ROLLING,
        _BALL + _MEASURED_MATERIAL + _ROLLING,
        _BALL + 'shear_modulus = { type = "hardness", hardness = 60, rebound = 0.5, reference_frequency = 9.0 }\n'
        "[groove]\nradius = 0.03\n" + _ROLLING,
        _BALL
        + 'shear_modulus = { type = "published", name = "vinyl_nitrile_foam", temperature = 303.15 }\n'
        + _ROLLING,
    )
)

_OSCILLATION = '\n[motion]\namplitude = 0.09\nfrequency = 1.0\ncycles = 3\nload = 50.0\nstart = "undeformed"\n'
MOTIONS = tuple(
    text.encode()
    for text in (
        example_text("motion"),
        _BALL + "shear_modulus = 1e6\n" + _OSCILLATION,
        _BALL + 'shear_modulus = 1e6\n[motion]\nfile = "motion.csv"\nfriction = 0.3\nmass = 0.1\n',
    )
)
MOTION_TABLES = (
    b"time,angle,load\n0.0,0.0,50\n0.5,1.0,60\n1.0,1.0,0\n",
    b"time,distance,center_displacement\n0,0,0\n1,0.01,0.011\n",
)

_DRAWN = """
[sweep]
"ball.layers[0].shear_modulus.temperature" = [20.0, 30.0]
"rolling.load" = { from = 10.0, to = 100.0, count = 3, scale = "log" }
[draws]
of = ["ball.layers[0].shear_modulus"]
confidence = 0.9
"""
STUDIES = (
    (example_text() + example_text("sweep")).encode(),
    (_BALL + _MEASURED_MATERIAL.replace(", draw = 1", "") + _ROLLING + _DRAWN).encode(),
)
DESIGNS = ((example_text() + example_text("design")).encode(),)

MATERIALS = (_MATERIAL.encode(),)

_TRIOS = (
    "Filename\tC:\\data\\rubber.tri\r\n[step]\r\nFrequency sweep - 1\r\n"
    "Angular frequency\tTemperature\tShear storage modulus\tShear loss modulus\tTan(delta)\r\n"
    "rad/s\t°C\tMPa\tkPa\t\r\n0.1\t20\t2.0\t10.0\t0.005\r\n1.0\t20\t2.5\t20.0\t0.008\r\n10\t20.1\t3.5\t40.0\t0.01\r\n"
)
_RHEOCOMPASS = (
    "Interval data:\tPoint No.\tTemperature\tAngular Frequency\tStorage Modulus\tLoss Modulus\tStatus\r\n"
    "\t\t[°C]\t[rad/s]\t[Pa]\t[Pa]\t\r\n\t1\t25\t100\t2,5E6\t3,1E5\tok\r\n\t2\t25\t10\t2,2E6\t2,5E5\tok\r\n"
)
_PROTEUS = "##Temp./°C;f/Hz;E'/MPa;E''/MPa;tan δ\n25,0;1,000;10,5;1,05;0,1\n25,0;10,000;12,5;1,5;0,12\n"
_PYVISCO = (
    "f,E_stor,E_loss,T,Set\nHz, MPa, MPa, C, -\n0.1,8097.1,93.0,-49.9,0\n0.2,8576.8,118.1,-49.9,0\n"
    "0.1,8000.1,90.0,-39.9,1\n0.2,8500.8,112.1,-39.9,1\n"
)
_RAMP = "T,f,E',E''\nC,Hz,MPa,MPa\n-20,1,900,90\n0,1,300,80\n20,1,20,8\n"
RHEOLOGY = (
    _TRIOS.encode("cp1252"),
    _RHEOCOMPASS.encode("utf-16"),
    _PROTEUS.encode(),
    _PYVISCO.encode("utf-8-sig"),
    _RAMP.encode(),
)
STRAIN_SWEEPS = (
    b"Strain,G',G''\n%,MPa,MPa\n0.1,5.0,0.4\n1.0,4.0,0.6\n10,2.0,0.4\n50,1.0,0.1\n",
    b"Oscillation strain\tAngular frequency\tStorage modulus\tTan(delta)\r\n%\trad/s\tkPa\t\r\n"
    b"0.1\t10\t5000\t0.1\r\n1.0\t10\t4000\t0.2\r\n10\t10\t2000\t0.2\r\n50\t10\t1000\t0.1\r\n",
)
FACTORS = (b"T,log_aT\nC,-\n100,-11.7\n92,-10.92\n85,-10.08\n20,0.0\n",)
MEASURED = (example_text("measured").encode(), b"load,penetration,error\n100,1e-4,1e-6\n50, 8e-5, 2e-6\n")
SURFACES = (
    b'{"what": "ln T", "load": [10.0, 100.0], "angular_speed": [0.5, 5.0], "radius": 0.021,\n'
    b'"coefficients": [[-4.0, 0.3], [1.2, 0.05]], "error": 0.01, "largest_error": 0.03}\n',
)
