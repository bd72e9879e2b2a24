#pragma once

// roomgen furnishes 3D rooms from a sentence. All its public headers, by what one does with them: each may
// also be included alone. Namespace roomgen; metres, radians, Z up, fronts towards -Y.

// Furnish a room.
#include "roomgen/generate/generate.h"      // from a plan to a furnished room or dwelling, at one go; its folder of files
#include "roomgen/generate/room_builder.h"  // the same one step at a time: propose, place, refuse, undo

// Change a furnished room.
#include "roomgen/edit/session.h"            // a room and its history: edits, undo, branches, differences
#include "roomgen/edit/operation.h"          // what an edit may do, as values
#include "roomgen/edit_reader/understand.h"  // sentences that say what to change, by rules or a model

// Decide what it holds: by rules, or by a language model.
#include "roomgen/design/designer.h"        // what a designer is; by rules, or by asking a language model; dwellings
#include "roomgen/scene/plan.h"             // what is asked of it, and what it makes of that; plan.json

// Look at a room, keep it, hand it on.
#include "roomgen/scene/scene.h"        // a furnished room or dwelling, with its meshes; scene.json
#include "roomgen/scene/room.h"         // its floor plan, doors and windows; room.json
#include "roomgen/scene/object.h"       // a thing in it, and where its mesh comes from
#include "roomgen/scene/relation.h"     // what a thing shall be to others: "near, bed-0"
#include "roomgen/scene/requirement.h"  // what the prompt asked for, met or not
#include "roomgen/view/view.h"          // how to look at a room; cameras, layers; what a renderer is
#include "roomgen/export/exporter.h"    // what an exporter is; GLB files; who made the meshes
#include "roomgen/import/import.h"      // floor plans from SVG and DXF; the meshes of a scene.glb

// Judge a room.
#include "roomgen/evaluate/report.h"  // what is wrong with it, which relations hold; how it meets written requirements

// Place things without a designer.
#include "roomgen/scene/problem.h"    // a room and things with constraints; problem.json
#include "roomgen/solve/solve.h"      // how one pose is chosen, the poses of all of them, many layouts of one room

// Bring meshes and kinds of things.
#include "roomgen/kinds/kind_table.h"  // what kinds of things there are: sizes, mounts, use zones
#include "roomgen/library/library.h"   // what an asset library is; several as one; a scene's meshes

// Make objects from words.
#include "roomgen/create/create.h"       // a sentence to objects; libraries of created objects
#include "roomgen/create/maker.h"        // what makes them: words to descriptions to programs, by rules or a model; the judge that sees
#include "roomgen/shape/program.h"       // a shape program: named parts of solids; programs with parameters
#include "roomgen/shape/primitives.h"    // the solids
#include "roomgen/shape/evaluate.h"      // a program's meshes

// Ask language models.
#include "roomgen/chat/chat_model.h"  // what a model is; recording, replay, cache, limits, prices; what models are told

// Words that all of them use.
#include "roomgen/base/cancel.h"       // stopping long work
#include "roomgen/base/file.h"         // files and folders that are written as a whole
#include "roomgen/base/json.h"         // JSON documents
#include "roomgen/base/result.h"       // a value or an error; where warnings go
#include "roomgen/base/text.h"         // small work on text
#include "roomgen/geometry/model.h"    // meshes, materials, pictures
#include "roomgen/geometry/polygon.h"  // the floor from above: segments, polygons, footprints
#include "roomgen/geometry/vec.h"      // points, directions, angles

// The parts that an installation may lack: link roomgen::assets, roomgen::render, roomgen::agent.
#if __has_include("roomgen/assets/catalogue.h")
#include "roomgen/assets/catalogue.h"  // furniture libraries: Sweet Home 3D archives, folders of meshes
#endif
#if __has_include("roomgen/render/pictures.h")
#include "roomgen/render/pictures.h"  // rooms and single models drawn without a display; PNG and JPEG
#endif
#if __has_include("roomgen/lab/program.h")
// The laboratory, which nothing else needs: link roomgen::lab.
#include "roomgen/lab/program.h"    // rooms described by constraints and scores: document, checker, words; program.json
#include "roomgen/lab/optimise.h"   // rooms that are as a program says, by annealing
#include "roomgen/lab/compose.h"    // programs for sentences, revised until they are met
#include "roomgen/lab/tour.h"       // a camera that walks to each thing and shows it; tour.json
#include "roomgen/lab/frames.h"     // what the pictures of a tour show; frames.jsonl
#include "roomgen/lab/questions.h"  // questions that the frames of a tour answer
#include "roomgen/lab/scores.h"     // how a room meets written requirements, after SceneEval
#include "roomgen/lab/suite.h"      // sentences of things with checks
#endif
#if __has_include("roomgen/lab/draw_frames.h")
#include "roomgen/lab/draw_frames.h"  // the frames of a tour with all layers and labels
#endif
#if __has_include("roomgen/agent/http_model.h")
#include "roomgen/agent/http_model.h"  // a language model behind an HTTP endpoint
#endif
