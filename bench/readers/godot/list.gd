# What Godot made of the GLB files of this project: a line of JSON each. It keeps names, and no extras.
extends SceneTree


func names_below(node, found):
    found.append({"name": node.name})
    for child in node.get_children():
        names_below(child, found)
    return found


func _init():
    var folder = Directory.new()
    folder.open("res://rooms")
    folder.list_dir_begin(true, true)
    var file = folder.get_next()
    while file != "":
        if file.ends_with(".glb"):
            var scene = load("res://rooms/" + file)
            if scene == null:
                print("found " + to_json({"file": file, "error": "was not imported"}))
            else:
                print("found " + to_json({"file": file, "nodes": names_below(scene.instance(), [])}))
        file = folder.get_next()
    quit()
