(3: Kleinbuchstabe x würde die Steuerung überlesen. Groß schreiben.)
P0001
N001 G00 x+1 Y+1
