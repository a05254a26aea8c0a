/* SPDX-License-Identifier: GPL-3.0-or-later */
/* [gear], [cam] and [roller_bearing]: keys of machine elements, whose
 * dimensions determine radii, speeds and loads of the contact. */
#include "case/keys/keys.h"

#define GEAR(field) AT(element.gear.field)
#define CAM(field) AT(element.cam.field)
#define BEARING(field) AT(element.bearing.field)
#define OF_LENGTH(minimum, maximum) WITH_UNIT(OVR_LENGTH, minimum, maximum)
#define OF_ANGLE(minimum, maximum) WITH_UNIT(OVR_ANGLE, minimum, maximum)
#define TURNING WITH_UNIT(OVR_ROTATION, -1e6, 1e6)
#define DEGREES(n) ((n)*0.017453292519943295)

/* ------------------------------------------------------------------- gear */

static const ovr_word sharings[] = {{"elastic", OVR_SHARING_ELASTIC},
                                    {"rule", OVR_SHARING_RULE},
                                    {"stiffness", OVR_SHARING_STIFFNESS},
                                    {"table", OVR_SHARING_TABLE},
                                    {NULL, 0}};

static const ovr_parameter gear_keys[] = {
    {"teeth_1", WHOLE(-2000, 2000), NULL, GEAR(teeth_1), true, ALWAYS,
     "teeth of gear 1, which is surface 1"},
    {"teeth_2", WHOLE(-2000, 2000), NULL, GEAR(teeth_2), true, ALWAYS,
     "teeth of gear 2; negative: an internal gear"},
    {"module", OF_LENGTH(1e-5, 1), NULL, GEAR(module), true, ALWAYS,
     "normal module"},
    {"pressure_angle", OF_ANGLE(DEGREES(5), DEGREES(45)), "20 deg",
     GEAR(pressure_angle), true, "teeth_1",
     "normal pressure angle on the reference cylinder"},
    {"helix_angle", OF_ANGLE(DEGREES(-60), DEGREES(60)), "0 deg",
     GEAR(helix_angle), true, "teeth_1",
     "helix angle on the reference cylinder; 0 deg: spur gears"},
    {"shift_1", PLAIN(-2, 2), NULL, GEAR(shift_1), true, ALWAYS,
     "profile shift coefficient of gear 1; default: 0, or the value that "
     "follows from the centre distance and shift_2"},
    {"shift_2", PLAIN(-2, 2), NULL, GEAR(shift_2), true, ALWAYS,
     "profile shift coefficient of gear 2; default: 0, or the value that "
     "follows from the centre distance and shift_1"},
    {"centre", OF_LENGTH(1e-5, 1e3), NULL, GEAR(centre), true, ALWAYS,
     "centre distance; default: zero backlash with the profile shifts"},
    {"addendum", PLAIN(0.1, 3), "1", GEAR(addendum), true, "teeth_1",
     "height of the teeth above the reference circle, in modules"},
    {"tip_1", OF_LENGTH(1e-5, 1e3), NULL, GEAR(tip_1), true, ALWAYS,
     "tip diameter of gear 1, instead of the addendum"},
    {"tip_2", OF_LENGTH(1e-5, 1e3), NULL, GEAR(tip_2), true, ALWAYS,
     "tip diameter of gear 2, instead of the addendum"},
    {"face", OF_LENGTH(1e-6, 1e2), NULL, GEAR(face), true, ALWAYS,
     "common width of the teeth"},
    {"speed", TURNING, NULL, GEAR(speed), true, ALWAYS,
     "speed of gear 1; the sign is ignored, because +x is the direction of "
     "motion of the surfaces"},
    {"driving", WHOLE(1, 2), "1", GEAR(driving), true, "teeth_1",
     "driving gear: the contact moves towards the tip of the driving gear 1, "
     "or towards its root if gear 2 drives"},
    {"torque", WITH_UNIT(OVR_TORQUE, 1e-9, 1e12), NULL, GEAR(torque), true,
     ALWAYS, "torque on gear 1"},
    {"power", WITH_UNIT(OVR_POWER, 1e-9, 1e15), NULL, AT(element.power), true,
     "no torque; teeth_1", "transmitted power, instead of the torque"},
    {"sharing", CHOICE(sharings), "elastic", GEAR(sharing), true, "teeth_1",
     "how pairs share the load: least elastic energy (Pedrero et al. 2010); "
     "1/3 to 2/3; springs by ISO 6336-1 with tip relief; a table"},
    {"file", PATH, NULL, AT(element.sharing_file), true,
     "sharing = table; teeth_1",
     "file of two columns: position in base pitches from A, load share"},
    {"blend", PLAIN(0, 0.5), "0.05", GEAR(blend), true,
     "sharing = elastic | rule; helix_angle == 0; teeth_1",
     "distance in base pitches over which the load rises at the start of "
     "single-pair contact"},
    {"relief_1", OF_LENGTH(0, 1e-2), "0 um", GEAR(relief_1), true,
     "sharing = stiffness; teeth_1", "tip relief of gear 1"},
    {"relief_2", OF_LENGTH(0, 1e-2), "0 um", GEAR(relief_2), true,
     "sharing = stiffness; teeth_1", "tip relief of gear 2"},
    {"relief_length_1", OF_LENGTH(1e-6, 1), NULL, GEAR(relief_length_1), true,
     "sharing = stiffness; relief_1 > 0; teeth_1",
     "length of the relief on the line of action; default: the region of "
     "double contact"},
    {"relief_length_2", OF_LENGTH(1e-6, 1), NULL, GEAR(relief_length_2), true,
     "sharing = stiffness; relief_2 > 0; teeth_1",
     "length of the relief on the line of action; default: the region of "
     "double contact"},
    {"mesh_stiffness", WITH_UNIT(OVR_MESH_STIFFNESS, 1e6, 1e15), NULL,
     GEAR(mesh_stiffness), true, "sharing = stiffness; teeth_1",
     "mesh stiffness c' of one pair per unit width; default: by ISO 6336-1"},
    {"slice", PLAIN(0, 1), "0.5", GEAR(slice), true,
     "helix_angle != 0; teeth_1",
     "position across the face width; 0: the end that enters contact first"},
    {"min_share", PLAIN(0, 0.5), "0.02", GEAR(min_share), true, "teeth_1",
     "the run begins and ends where the load share of the pair exceeds this "
     "value"},
    {"min_radius", PLAIN(0, 0.4), "0.05", GEAR(min_radius), true, "teeth_1",
     "and where the radius of a flank exceeds this share of the line of "
     "action"},
};

const ovr_section ovr_gear_section = {
    "gear", false, NULL,
    "a gear tooth pair, which determines radius, speeds and load of the "
    "contact in time",
    ROWS(gear_keys)};

/* -------------------------------------------------------------------- cam */

static const ovr_word followers[] = {
    {"flat", OVR_FOLLOWER_FLAT}, {"roller", OVR_FOLLOWER_ROLLER}, {NULL, 0}};
static const ovr_word laws[] = {
    {"4567", OVR_CAM_4567},           {"345", OVR_CAM_345},
    {"cycloidal", OVR_CAM_CYCLOIDAL}, {"harmonic", OVR_CAM_HARMONIC},
    {"table", OVR_CAM_TABLE},         {NULL, 0}};
#define BY_LAW "law = 4567 | 345 | cycloidal | harmonic"

static const ovr_parameter cam_keys[] = {
    {"follower", CHOICE(followers), "flat", CAM(follower), true, "base_radius",
     "flat, or a roller; moves along a line through the axis "
     "of the cam"},
    {"base_radius", OF_LENGTH(1e-5, 1e2), NULL, CAM(base_radius), true, ALWAYS,
     "radius of the base circle"},
    {"roller_radius", OF_LENGTH(1e-5, 1e2), NULL, CAM(roller_radius), true,
     "follower = roller; base_radius", "radius of the follower's roller"},
    {"face", OF_LENGTH(1e-6, 1e2), NULL, CAM(face), true, ALWAYS,
     "width of the contact"},
    {"speed", WITH_UNIT(OVR_ROTATION, 1e-9, 1e6), NULL, CAM(speed), true,
     ALWAYS, "speed of the cam (surface 1)"},
    {"law", CHOICE(laws), "4567", CAM(law), true, "base_radius",
     "lift law: polynomials 4-5-6-7 or 3-4-5, cycloidal, harmonic, or a table"},
    {"lift", OF_LENGTH(1e-6, 1e2), NULL, CAM(lift), true,
     BY_LAW "; base_radius", "maximum lift"},
    {"rise", OF_ANGLE(DEGREES(1), DEGREES(360)), NULL, CAM(rise), true,
     BY_LAW "; base_radius", "angle of the rise"},
    {"dwell", OF_ANGLE(0, DEGREES(360)), "0 deg", CAM(dwell), true,
     BY_LAW "; base_radius", "angle of the dwell"},
    {"fall", OF_ANGLE(DEGREES(1), DEGREES(360)), NULL, CAM(fall), true,
     BY_LAW "; base_radius", "angle of the fall; default: that of the rise"},
    {"file", PATH, NULL, AT(element.lift_file), true,
     "law = table; base_radius",
     "file of two columns: angle from the start of the rise, lift; degrees and "
     "mm, or in the units of the header"},
    {"spring", WITH_UNIT(OVR_STIFFNESS, 0, 1e12), NULL, CAM(spring), true,
     ALWAYS, "stiffness of the follower spring"},
    {"preload", WITH_UNIT(OVR_FORCE, 0, 1e9), NULL, CAM(preload), true, ALWAYS,
     "spring force at zero lift"},
    {"mass", WITH_UNIT(OVR_MASS, 0, 1e6), "0 kg", CAM(mass), true,
     "base_radius", "moving mass of the follower"},
    {"slip", WITH_UNIT(OVR_SHARE, -1.9, 1.9), "0", CAM(slip), true,
     "follower = roller; base_radius",
     "slide-to-roll ratio (u1 - u2)/u_m of "
     "the roller"},
    {"from", OF_ANGLE(DEGREES(-360), DEGREES(720)), NULL, CAM(from), true,
     ALWAYS, "angle at the start of the run; default: start of the rise"},
    {"to", OF_ANGLE(DEGREES(-360), DEGREES(720)), NULL, CAM(to), true, ALWAYS,
     "angle at the end of the run; default: end of the fall"},
};

const ovr_section ovr_cam_section = {
    "cam", false, NULL,
    "a cam and its follower, which determine radius, speeds and load of the "
    "contact in time",
    ROWS(cam_keys)};

/* ---------------------------------------------------------------- bearing */

static const ovr_word rings[] = {{"inner", 1}, {"outer", 2}, {NULL, 0}};
static const ovr_word positions[] = {{"roller", OVR_ROLLER_BELOW},
                                     {"gap", OVR_GAP_BELOW},
                                     {"angle", OVR_ROLLER_AT},
                                     {NULL, 0}};

static const ovr_word passes[] = {{"none", OVR_ROLLER_PASSES_NONE},
                                  {"zone", OVR_ROLLER_PASSES_ZONE},
                                  {"turns", OVR_ROLLER_PASSES_TURNS},
                                  {NULL, 0}};

static const ovr_parameter bearing_keys[] = {
    {"roller", OF_LENGTH(1e-5, 1e2), NULL, BEARING(roller), true, ALWAYS,
     "diameter of a roller"},
    {"rollers", WHOLE(3, OVR_ROLLERS_MAX), NULL, BEARING(rollers), true, ALWAYS,
     "number of rollers"},
    {"length", OF_LENGTH(1e-6, 1e2), NULL, BEARING(length), true, ALWAYS,
     "effective length of a roller"},
    {"inner", OF_LENGTH(1e-5, 1e3), NULL, BEARING(inner), true, ALWAYS,
     "diameter of the inner raceway"},
    {"pitch", OF_LENGTH(1e-5, 1e3), NULL, BEARING(pitch), true, ALWAYS,
     "diameter of the pitch circle, instead of inner"},
    {"clearance", OF_LENGTH(-1e-2, 1e-2), "0 um", BEARING(clearance), true,
     "rollers", "diametral clearance; negative: preloaded"},
    {"load", WITH_UNIT(OVR_FORCE, 1e-3, 1e12), NULL, BEARING(load), true,
     ALWAYS, "radial force, constant in direction"},
    {"speed_inner", TURNING, "0 rpm", BEARING(speed_inner), true, "rollers",
     "rotational speed of the inner ring"},
    {"speed_outer", TURNING, "0 rpm", BEARING(speed_outer), true, "rollers",
     "rotational speed of the outer ring"},
    {"contact", CHOICE(rings), "inner", BEARING(contact), true, "rollers",
     "raceway of the contact (surface 1)"},
    {"slip", WITH_UNIT(OVR_SHARE, -1.9, 1.9), "0", BEARING(slip), true,
     "rollers", "slide-to-roll ratio (u1 - u2)/u_m at the given raceway speed"},
    {"position", CHOICE(positions), "roller", BEARING(position), true,
     "rollers",
     "position of the rollers relative to the load direction: a roller, a gap, "
     "or a roller at an angle"},
    {"angle", OF_ANGLE(DEGREES(-360), DEGREES(360)), "0 deg", BEARING(angle),
     true, "position = angle; rollers", "position of that roller"},
    {"passes", CHOICE(passes), "none", AT(element.passes), true, "rollers",
     "zone: the passes are the rollers that one point of the raceway meets "
     "in one crossing of the load zone; turns: passes.number rollers of the "
     "same load, for a stationary ring"},
    {"stiffness", POSITIVE(1e30), NULL, BEARING(stiffness), true, ALWAYS,
     "contact stiffness K of a roller between both rings, Q = K d^(10/9), in "
     "N/m^(10/9); default: by Palmgren"},
};

const ovr_section ovr_roller_bearing_section = {
    "roller_bearing", false, NULL,
    "a cylindrical roller bearing under a radial load, which determines "
    "radius, speeds and load of the contact and the passes of its rollers",
    ROWS(bearing_keys)};
