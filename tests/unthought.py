# SPDX-License-Identifier: MIT
"""Programs that nobody thought of, as strategies of hypothesis."""

from hypothesis import strategies as st

coordinate = st.floats(-30, 30).map(lambda x: f"{x:.3f}")
step = st.floats(-0.02, 0.02).map(lambda x: f"{x:.6f}")
feed = st.integers(30, 12000).map(lambda f: f"F{f}")
line = st.builds("G90 G1 X{} Y{} Z{}".format, coordinate, coordinate, coordinate)
rapid = st.builds("G90 G0 X{} Y{}".format, coordinate, coordinate)
micro = st.lists(st.builds("X{} Y{} Z{}".format, step, step, step), min_size=1, max_size=60).map(
    lambda words: "G91 G1 " + "\n".join(words)
)
back = st.builds("G91 G1 X{0}\nX-{0}\nX{0}".format, st.floats(0.001, 5).map(lambda x: f"{x:.4f}"))
arc = st.builds(
    "G91 G{} X0 Y0 I{:.4f} J{:.4f}".format,
    st.sampled_from((2, 3)), st.floats(0.01, 10), st.floats(-10, 10),
)  # fmt: skip
helix = st.builds("G91 G3 Z{} I{:.4f} J0".format, coordinate, st.floats(0.05, 5))
corner_arc = st.builds(
    "G91 G{0} X{1:.4f} Y{2:.4f} R{3:.4f}".format,
    st.sampled_from((2, 3)), st.floats(0.01, 5), st.floats(0.01, 5),
    st.sampled_from((-7.5, 7.5, 20)),
)  # fmt: skip
dwell = st.floats(0, 0.05).map(lambda t: f"G4 P{t:.5f}")
other = st.sampled_from(("G61", "G61.1", "G64", "M0", "M8", "S500"))
move = st.one_of(line, rapid, micro, back, arc, helix, corner_arc, dwell, other, feed)
program_text = st.lists(move, min_size=1, max_size=30).map(
    lambda moves: "\n".join(["G17 G21 G94 G90 F3000", *moves, "M2", ""])
)
