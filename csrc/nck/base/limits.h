// SPDX-License-Identifier: MIT
// Capacities: every size of the kernel, known at compile time. Override with -D for all files.
#ifndef NCK_BASE_LIMITS_H
#define NCK_BASE_LIMITS_H

// Axes a program may name, in the order X Y Z A B C U V W. Range 3..9. Fewer axes make segs
// smaller.
#ifndef NCK_AXIS_MAX
#define NCK_AXIS_MAX 9
#endif

// Longest source line in bytes. Range 80..65535. A longer line is the error NCK_E_LINE_LENGTH.
#ifndef NCK_LINE_MAX
#define NCK_LINE_MAX 512
#endif

// Tools in the table. Range 1..1000. An H or T word that is not in the table is an error.
#ifndef NCK_TOOL_MAX
#define NCK_TOOL_MAX 32
#endif

// M codes of the machine's own; G codes whose meaning it says; work systems behind G59.3 (G54.1 P)
// that it has zeros of: so many of each. Range 1..1000.
#ifndef NCK_OWN_M_MAX
#define NCK_OWN_M_MAX 16
#endif

// Parameters of programs (#1, #<depth>) that are set at once, in all calls. Range 0..65536.
// 0 leaves out expressions, parameters and what needs them: calls, jumps and loops.
#ifndef NCK_VARIABLES
#define NCK_VARIABLES 128
#endif

// Calls and loops in force at once. Range 0..1000. 0 leaves out calls, jumps and loops.
#ifndef NCK_CALL_DEPTH
#define NCK_CALL_DEPTH 16
#endif

// Words of shops that the language has. Range 0..4. 4: all of them. 3: no threads and taps, so that
// the tick follows no spindle, and no mirrored, scaled, turned and polar coordinates (G15 G16 G50
// G51 G50.1 G51.1 G68 G69, @ and ^). 2: nor what lathes have: Fanuc's systems of G codes, U and W
// as steps, G96. 1: nor what one control has alone: modes (G5.1, G187), G codes of the machine's
// own, printers' words, ports (M62 … M68), M70 … M73. 0: nor cycles and radius compensation,
// whatever NCK_CYCLES, NCK_CONTOUR and NCK_COMP_SPAN say.
#ifndef NCK_LANGUAGE
#define NCK_LANGUAGE 4
#endif

// Canned cycles: G73 G81 G82 G83 G85 G86 G89, G98 G99. 0 leaves them out, and G30 P3 P4.
#ifndef NCK_CYCLES
#define NCK_CYCLES 1
#endif

// Lines and arcs of the contour of G70, G71, G72 and G73 (lathes). 0 or 8..10000. 0 leaves these
// cycles out.
#ifndef NCK_CONTOUR
#define NCK_CONTOUR 100
#endif

// Blocks that radius compensation (G41, G42) sees at once. Power of two, 16..4096. 0 leaves it out.
// What lies closer together than they are long is held against each other.
#ifndef NCK_COMP_SPAN
#define NCK_COMP_SPAN 64
#endif

// Nodes of the look-ahead window (three a seg at most). Power of two, 16..65536. Too short
// for the braking distance costs time, never safety; it is reported as limit "lookahead".
#ifndef NCK_WINDOW
#define NCK_WINDOW 256
#endif

// Junctions on either side that share one interpolation period at most. Power of two, 2..256.
// Denser paths are slowed down until the span covers a period.
#ifndef NCK_CORNER_SPAN
#define NCK_CORNER_SPAN 64
#endif

// Taps of the jerk-limited slope's output filter: a mean of the path coordinate over so many
// periods. Range 1..16. More taps round the steps of acceleration more, and round corners of the
// speed profile earlier.
#ifndef NCK_FILTER_TAPS
#define NCK_FILTER_TAPS 4
#endif

// Nodes of the jerk-limited slope's window. Power of two, 32..65536. A node lasts half a period
// (two to four periods if the window would else be shorter than braking takes): fewer nodes cost
// time, never safety. 0 leaves it out, and "optimal".
#ifndef NCK_PROFILE
#define NCK_PROFILE 1024
#endif

// Knots of the optimal slope's window (path.slope = "optimal"), which alone smooths within a
// tolerance. A multiple of 8, 64..1024; 0 leaves it out: the path is exact under G64, too. It needs
// the jerk-limited slope and segs for one and a half windows. 64 last 0.15 to 0.26 s on the shipped
// machines: half of them is what a stop takes, so fewer would be no window. Below 256 its solvers
// have single precision, half of the memory, and knots are further apart: 64, 96 and 128 take 1.1,
// 0.6 and 0.5 % more time than 256 on families.
#ifndef NCK_CLOCKED
#define NCK_CLOCKED 96
#endif

// Cells between the slope and the tick. Power of two, 16..4096. More cells bridge longer pauses of
// prep.
#ifndef NCK_CELL_MAX
#define NCK_CELL_MAX 128
#endif

// Segs alive at once: window, corner span and cells all point into this ring.
#define NCK_SEG_MAX (2 * NCK_WINDOW)

// Nodes in the ring of the look-ahead: a window of the exact path, or what two plans of the optimal
// slope see, one of which begins half a window behind the other; there a seg is one node.
#if NCK_CLOCKED > 0 && 3 * NCK_CLOCKED + 40 > 2 * NCK_WINDOW
#define NCK_NODE_MAX NCK_SEG_MAX
#else
#define NCK_NODE_MAX NCK_WINDOW
#endif

// Cells of a stop tail: the rest of the window, to rest.
#if NCK_PROFILE > NCK_WINDOW
#define NCK_TAIL_LEAST NCK_PROFILE
#else
#define NCK_TAIL_LEAST NCK_WINDOW
#endif
// An interval of the optimal slope's window is two cells at least, often more.
#if 3 * NCK_CLOCKED > NCK_TAIL_LEAST
#define NCK_TAIL_MAX (3 * NCK_CLOCKED)
#else
#define NCK_TAIL_MAX NCK_TAIL_LEAST
#endif

// Outputs (S, M, T words) alive at once beside the segs. Power of two.
#define NCK_OUTPUT_MAX (2 * NCK_WINDOW)

// Whether the language has expressions and parameters, calls, jumps and loops, canned cycles,
// layouts.
#define NCK_HAS_VARIABLES (NCK_VARIABLES > 0)
#define NCK_HAS_CALLS (NCK_VARIABLES > 0 && NCK_CALL_DEPTH > 0)
#define NCK_HAS_CYCLES (NCK_LANGUAGE > 0 && NCK_CYCLES > 0)
#define NCK_HAS_LAYOUTS (NCK_LANGUAGE > 3)
#define NCK_HAS_CONTOUR (NCK_HAS_CYCLES && NCK_CONTOUR > 0)
// Whether it has threads and taps, which are cycles' kin; words of lathes; those that one control
// has alone.
#if NCK_LANGUAGE > 3 && NCK_HAS_CYCLES
#define NCK_HAS_THREADS 1
#else
#define NCK_HAS_THREADS 0
#endif
#define NCK_HAS_LATHE (NCK_LANGUAGE > 2)
#define NCK_HAS_FOREIGN (NCK_LANGUAGE > 1)

// Whether there is radius compensation; the jerk-limited slope.
#define NCK_HAS_COMP (NCK_LANGUAGE > 0 && NCK_COMP_SPAN > 0)
#define NCK_HAS_JERK (NCK_PROFILE > 0)
// Whether the optimal slope's solvers have single precision.
#define NCK_SINGLE (NCK_CLOCKED > 0 && NCK_CLOCKED < 256)
// Whether there is the optimal slope, which smooths.
#define NCK_HAS_OPTIMAL (NCK_CLOCKED > 0)
// Whether a jerk-limited plan is made as good as it can be: a short window has no time for it.
#define NCK_HAS_BEST (NCK_PROFILE >= 256)
// Whether the linear slope is made for even polygons: its corners get more there (room 4,
// corner.c), and holds know it (room 5, linear_left.c). A shorter window seldom holds enough.
#define NCK_HAS_POLYGONS (NCK_WINDOW >= 256)

// What holds the state of cycles, of threads, of layouts, of parameters and calls, of compensation,
// of marks, of the jerk-limited slope. Where they are left out it is only read, as zero:
// one place serves all members.
#if NCK_HAS_CYCLES
#define NCK_CYCLE_STATE struct
#else
#define NCK_CYCLE_STATE union
#endif
#if NCK_HAS_THREADS
#define NCK_THREAD_STATE struct
#else
#define NCK_THREAD_STATE union
#endif
#if NCK_HAS_LAYOUTS
#define NCK_LAYOUT_STATE struct
#else
#define NCK_LAYOUT_STATE union
#endif
#if NCK_VARIABLES > 0
#define NCK_MACRO_STATE struct
#else
#define NCK_MACRO_STATE union
#endif
#if NCK_HAS_COMP
#define NCK_COMP_STATE struct
#else
#define NCK_COMP_STATE union
#endif
#if NCK_CLOCKED > 0
#define NCK_MARK_STATE struct
#else
#define NCK_MARK_STATE union
#endif
#if NCK_PROFILE > 0
#define NCK_JERK_STATE struct
#else
#define NCK_JERK_STATE union
#endif

// Whether a program that begins in the middle has what it has put out before, its address. A build
// without parameters begins there with modes, tool and spindle alone.
#define NCK_HAS_KEPT (NCK_HAS_FOREIGN && NCK_VARIABLES > 0)
#if NCK_HAS_KEPT
#define NCK_KEPT_MEMBER(type, name) type name;
#define NCK_KEPT_AT(self, name) (&(self)->name)
#else
#define NCK_KEPT_MEMBER(type, name)
#define NCK_KEPT_AT(self, name) ((void *)0)
#endif

// What the machine's clocks say, which parameters alone tell: a member, its address, and what else
// only builds with parameters have.
#if NCK_HAS_VARIABLES
#define NCK_IF_VARIABLES(...) __VA_ARGS__
#define NCK_CLOCK_AT(machine) (&(machine)->clock)
#else
#define NCK_IF_VARIABLES(...)
#define NCK_CLOCK_AT(machine) ((void *)0)
#endif

// A member that only builds with the optimal slope have, and its address: elsewhere nobody asks for
// it, or one of the same type that is there serves in its place.
#if NCK_HAS_OPTIMAL
#define NCK_OPTIMAL_MEMBER(type, name) type name;
#define NCK_OPTIMAL_AT(self, name) (&(self)->name)
#define NCK_OPTIMAL_OR(self, name, other) (&(self)->name)
#define NCK_OPTIMAL_VALUE(self, name) ((self)->name)
#else
#define NCK_OPTIMAL_MEMBER(type, name)
#define NCK_OPTIMAL_AT(self, name) ((void *)0)
#define NCK_OPTIMAL_OR(self, name, other) (&(self)->other)
#define NCK_OPTIMAL_VALUE(self, name) 0u
#endif

// Intervals of a window of the curve, elements of its track, outputs on their way along it
// (3_smooth/CURVE.md), nodes of a motion's window (base/motion.h). Where there is no optimal slope
// they are those of its rooms' tests.
// Sets of words along the track that change seldom: G96, and how the feed is meant, which rotary
// axes change from line to line.
#if NCK_CLOCKED >= 256
#define NCK_CLOCKED_TRACK 4096
#define NCK_CLOCKED_OUTPUTS 1024
#else
#define NCK_CLOCKED_OUTPUTS 64
#if NCK_CLOCKED > 0
#define NCK_CLOCKED_TRACK 256
#elif NCK_PROFILE < 512
#define NCK_CLOCKED_TRACK 64
#else
#define NCK_CLOCKED_TRACK 512
#endif
#endif
#if NCK_CLOCKED > 0
#define NCK_CLOCKED_WINDOW NCK_CLOCKED
#define NCK_CLOCKED_AXES NCK_AXIS_MAX
#define NCK_MOTION_NODES (NCK_CLOCKED + 8)
#elif NCK_PROFILE < 512
#define NCK_CLOCKED_AXES 1
#define NCK_CLOCKED_WINDOW 48
#define NCK_MOTION_NODES 96
#else
#define NCK_CLOCKED_AXES 1
#define NCK_CLOCKED_WINDOW 128
#define NCK_MOTION_NODES 264
#endif
// Whether the fastest curve of a window is kept: with 64 knots of three axes 4 KB.
#if NCK_CLOCKED_WINDOW > 64
#define NCK_HAS_FASTEST 1
#else
#define NCK_HAS_FASTEST 0
#endif
#if NCK_AXIS_MAX > 3
#define NCK_CLOCKED_WORDS NCK_CLOCKED_TRACK
#else
#define NCK_CLOCKED_WORDS 16
#endif
// Nodes that are worked on side by side: sums over nodes are sums of so many sums, whatever the
// processor, so that loops become vectors of the same bits.
#define NCK_MOTION_LANES 8

// Reference points: G28, G30 (P2), G30 P3, G30 P4.
#if NCK_HAS_CYCLES
#define NCK_HOMES 4
#else
#define NCK_HOMES 2
#endif

// Rows of arrays that may be left out.
#if NCK_HAS_COMP
#define NCK_COMP_ROWS NCK_COMP_SPAN
#else
#define NCK_COMP_ROWS 1
#endif
// Marks of source lines along the path alive at once: two for each seg of the ring, 16 B each. Of
// chords shorter than half a seg some are told as a neighbour once the ring is full. Power of two.
// Without smoothing a seg is of one line.
#if NCK_CLOCKED > 0
#define NCK_HAS_MARKS 1
#define NCK_MARK_MAX (4 * NCK_WINDOW)
#else
#define NCK_HAS_MARKS 0
#define NCK_MARK_MAX 1
#endif
#if NCK_PROFILE > 0
#define NCK_PROFILE_ROWS NCK_PROFILE
#else
#define NCK_PROFILE_ROWS 1
#endif
#if NCK_HAS_CONTOUR
#define NCK_CONTOUR_ROWS NCK_CONTOUR
#else
#define NCK_CONTOUR_ROWS 1
#endif
#if NCK_VARIABLES > 0
#define NCK_VARIABLE_ROWS NCK_VARIABLES
#else
#define NCK_VARIABLE_ROWS 1
#endif
#if NCK_HAS_LAYOUTS
#define NCK_TURNED_ROWS 9 // work systems that may be turned: NCK_WORK_SYSTEMS
#else
#define NCK_TURNED_ROWS 1
#endif
#if NCK_CALL_DEPTH > 0
#define NCK_FRAME_ROWS NCK_CALL_DEPTH
#define NCK_LABEL_ROWS 8
#define NCK_STATE_ROWS 4
#else
#define NCK_FRAME_ROWS 1
#define NCK_LABEL_ROWS 1
#define NCK_STATE_ROWS 1
#endif

#if NCK_AXIS_MAX < 3 || NCK_AXIS_MAX > 9
#error "NCK_AXIS_MAX must be 3..9"
#endif
#if NCK_VARIABLES < 0 || NCK_VARIABLES > 65536
#error "NCK_VARIABLES must be 0..65536"
#endif
#if NCK_CALL_DEPTH < 0 || NCK_CALL_DEPTH > 1000
#error "NCK_CALL_DEPTH must be 0..1000"
#endif
#if NCK_LANGUAGE < 0 || NCK_LANGUAGE > 4
#error "NCK_LANGUAGE must be 0..4"
#endif
#if NCK_CONTOUR != 0 && (NCK_CONTOUR < 8 || NCK_CONTOUR > 10000)
#error "NCK_CONTOUR must be 0 or 8..10000"
#endif
#if NCK_COMP_SPAN != 0 && (NCK_COMP_SPAN < 16 || NCK_COMP_SPAN > 4096)
#error "NCK_COMP_SPAN must be 0 or 16..4096"
#endif
#if NCK_COMP_SPAN & (NCK_COMP_SPAN - 1)
#error "NCK_COMP_SPAN must be a power of two"
#endif
#if NCK_FILTER_TAPS < 1 || NCK_FILTER_TAPS > 16
#error "NCK_FILTER_TAPS must be 1..16"
#endif
#if (NCK_WINDOW & (NCK_WINDOW - 1)) || NCK_WINDOW < 16
#error "NCK_WINDOW must be a power of two, 16 at least"
#endif
#if NCK_PROFILE != 0 && (NCK_PROFILE < 32 || NCK_PROFILE > 65536)
#error "NCK_PROFILE must be 0 or 32..65536"
#endif
#if NCK_PROFILE & (NCK_PROFILE - 1)
#error "NCK_PROFILE must be a power of two"
#endif
#if (NCK_CELL_MAX & (NCK_CELL_MAX - 1)) || NCK_CELL_MAX < 16
#error "NCK_CELL_MAX must be a power of two, 16 at least"
#endif
#if NCK_CLOCKED != 0 && (NCK_CLOCKED < 64 || NCK_CLOCKED > 1024 || NCK_CLOCKED % 8 != 0)
#error "NCK_CLOCKED must be 0 or 64..1024, a multiple of 8"
#endif
#if NCK_CLOCKED > 0 && NCK_PROFILE == 0
#error "NCK_CLOCKED needs NCK_PROFILE"
#endif
// A plan begins half a window behind the one before and has all pieces of its own. Without their
// room it would wait for what has none.
#if NCK_CLOCKED > 0 && 3 * NCK_CLOCKED + 40 > 4 * NCK_WINDOW
#error "3 * NCK_CLOCKED + 40 must not exceed 4 * NCK_WINDOW"
#endif
#if (NCK_CORNER_SPAN & (NCK_CORNER_SPAN - 1)) || NCK_CORNER_SPAN < 2
#error "NCK_CORNER_SPAN must be a power of two, 2 at least"
#endif
// Otherwise the seg ring could fill up before a plan has its pieces (5_slope: 8 less than the
// window holds), and neither side could go on.
#if 2 * NCK_CORNER_SPAN + NCK_CELL_MAX > NCK_WINDOW + 8
#error "2 * NCK_CORNER_SPAN + NCK_CELL_MAX must not exceed NCK_WINDOW + 8"
#endif

#endif
