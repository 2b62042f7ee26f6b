<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>ClipTool</name>
    <message>
        <source>Crop</source>
        <translation>Zuschneiden</translation>
    </message>
    <message>
        <source>Move the clip plane</source>
        <translation>Schnittebene verschieben</translation>
    </message>
    <message>
        <source>Tilt the clip plane</source>
        <translation>Schnittebene kippen</translation>
    </message>
</context>
<context>
    <name>Dialogs</name>
    <message>
        <source>Menu: %1</source>
        <translation>Menü: %1</translation>
    </message>
    <message>
        <source>Keys and mouse</source>
        <translation>Tasten und Maus</translation>
    </message>
    <message>
        <source>What the mouse does in each view, then the keys of the menus.</source>
        <translation>Was die Maus in jeder Ansicht bewirkt, danach die Tasten der Menüs.</translation>
    </message>
    <message>
        <source>not available</source>
        <translation>nicht verfügbar</translation>
    </message>
    <message>
        <source> (shader schedule: %1)</source>
        <translation> (Shader-Zeitplan: %1)</translation>
    </message>
    <message>
        <source>About Fenestra</source>
        <translation>Über Fenestra</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Fenestra %1&lt;/h3&gt;&lt;p&gt;A medical volume viewer that opens an adaptive cutaway around the structure you want to see.&lt;/p&gt;&lt;p&gt;&lt;b&gt;Not for diagnostic use.&lt;/b&gt;&lt;/p&gt;&lt;p&gt;Free software under the GNU General Public License, version 3 or later. It comes with no warranty.&lt;/p&gt;&lt;p&gt;3-D views: %2&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Fenestra %1&lt;/h3&gt;&lt;p&gt;Ein Betrachter für medizinische Volumen, der einen adaptiven Freischnitt um die gewünschte Struktur öffnet.&lt;/p&gt;&lt;p&gt;&lt;b&gt;Nicht für diagnostische Zwecke.&lt;/b&gt;&lt;/p&gt;&lt;p&gt;Freie Software unter der GNU General Public License, Version 3 oder später. Ohne jede Gewährleistung.&lt;/p&gt;&lt;p&gt;3-D-Ansichten: %2&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Schichten</translation>
    </message>
    <message>
        <source>Click</source>
        <translation>Klick</translation>
    </message>
    <message>
        <source>crosshair; the label there, or the region around the place, becomes the focus</source>
        <translation>Fadenkreuz; das Label dort, oder die Region um die Stelle, wird zum Fokus</translation>
    </message>
    <message>
        <source>Ctrl+click</source>
        <translation>Strg+Klick</translation>
    </message>
    <message>
        <source>the label joins or leaves the focus</source>
        <translation>Label kommt zum Fokus oder verlässt ihn</translation>
    </message>
    <message>
        <source>Drag</source>
        <translation>Ziehen</translation>
    </message>
    <message>
        <source>window width (across) and level (up and down)</source>
        <translation>Fensterbreite (quer) und Fensterzentrum (auf und ab)</translation>
    </message>
    <message>
        <source>Ctrl+double-click</source>
        <translation>Strg+Doppelklick</translation>
    </message>
    <message>
        <source>window and level of the data</source>
        <translation>Fensterung der Daten</translation>
    </message>
    <message>
        <source>Wheel, arrows</source>
        <translation>Rad, Pfeiltasten</translation>
    </message>
    <message>
        <source>next and previous slices</source>
        <translation>nächste und vorige Schichten</translation>
    </message>
    <message>
        <source>Page up, Page down</source>
        <translation>Bild auf, Bild ab</translation>
    </message>
    <message>
        <source>ten slices</source>
        <translation>zehn Schichten</translation>
    </message>
    <message>
        <source>Measures, on the slices</source>
        <translation>Messungen, auf den Schichten</translation>
    </message>
    <message>
        <source>Drag, or clicks</source>
        <translation>Ziehen oder Klicks</translation>
    </message>
    <message>
        <source>Drag a handle or line</source>
        <translation>Griff oder Linie ziehen</translation>
    </message>
    <message>
        <source>move the end, or the measure</source>
        <translation>das Ende oder die Messung verschieben</translation>
    </message>
    <message>
        <source>Right click on it</source>
        <translation>Rechtsklick darauf</translation>
    </message>
    <message>
        <source>Clipping, while its tab is in sight</source>
        <translation>Beschnitt, solange seine Karte zu sehen ist</translation>
    </message>
    <message>
        <source>Drag a square</source>
        <translation>Quadrat ziehen</translation>
    </message>
    <message>
        <source>move a face of the box, or a plane</source>
        <translation>eine Seite des Quaders oder eine Ebene verschieben</translation>
    </message>
    <message>
        <source>Drag the ball at an arrow</source>
        <translation>Kugel an einem Pfeil ziehen</translation>
    </message>
    <message>
        <source>tilt the plane</source>
        <translation>Ebene kippen</translation>
    </message>
    <message>
        <source>Walls of slices, in the 3-D views</source>
        <translation>Schichtwände, in den 3-D-Ansichten</translation>
    </message>
    <message>
        <source>move the slice of that colour</source>
        <translation>die Schicht dieser Farbe verschieben</translation>
    </message>
    <message>
        <source>3-D views</source>
        <translation>3-D-Ansichten</translation>
    </message>
    <message>
        <source>Drag, arrows</source>
        <translation>Ziehen, Pfeiltasten</translation>
    </message>
    <message>
        <source>rotate; the linked view follows</source>
        <translation>drehen; die gekoppelte Ansicht folgt</translation>
    </message>
    <message>
        <source>crosshair to what is seen there; its label or region becomes the focus</source>
        <translation>Fadenkreuz auf das, was dort zu sehen ist; sein Label oder seine Region wird zum Fokus</translation>
    </message>
    <message>
        <source>its label joins or leaves the focus</source>
        <translation>sein Label kommt zum Fokus oder verlässt ihn</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Rad</translation>
    </message>
    <message>
        <source>zoom</source>
        <translation>vergrößern</translation>
    </message>
    <message>
        <source>A grown region, in all views</source>
        <translation>Gewachsene Region, in allen Ansichten</translation>
    </message>
    <message>
        <source>Shift+click</source>
        <translation>Umschalt+Klick</translation>
    </message>
    <message>
        <source>add what is there to the region</source>
        <translation>zur Region hinzufügen, was dort liegt</translation>
    </message>
    <message>
        <source>take what is there away from the region</source>
        <translation>aus der Region nehmen, was dort liegt</translation>
    </message>
    <message>
        <source>Shift+drag</source>
        <translation>Umschalt+Ziehen</translation>
    </message>
    <message>
        <source>draw a ball around a structure: the region that grows there stays within it</source>
        <translation>Kugel um eine Struktur ziehen: die Region, die dort wächst, bleibt darin</translation>
    </message>
    <message>
        <source>Alt+wheel</source>
        <translation>Alt+Rad</translation>
    </message>
    <message>
        <source>tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Eingabe</translation>
    </message>
    <message>
        <source>open the 3-D views to a large or doubtful region, which asks before</source>
        <translation>die 3-D-Ansichten zu einer großen oder zweifelhaften Region öffnen, die vorher fragt</translation>
    </message>
    <message>
        <source>Painting the region, in all views</source>
        <translation>Region malen, in allen Ansichten</translation>
    </message>
    <message>
        <source>add what the ball passes over</source>
        <translation>hinzufügen, worüber die Kugel fährt</translation>
    </message>
    <message>
        <source>take it away</source>
        <translation>wegnehmen</translation>
    </message>
    <message>
        <source>Brush, in the 3-D views</source>
        <translation>Pinsel, in den 3-D-Ansichten</translation>
    </message>
    <message>
        <source>paint</source>
        <translation>malen</translation>
    </message>
    <message>
        <source>Ctrl+drag</source>
        <translation>Strg+Ziehen</translation>
    </message>
    <message>
        <source>rotate</source>
        <translation>drehen</translation>
    </message>
    <message>
        <source>Shift+wheel, Shift+drag</source>
        <translation>Umschalt+Rad, Umschalt+Ziehen</translation>
    </message>
    <message>
        <source>depth, or by how much the context&apos;s edges change</source>
        <translation>Tiefe, oder um wie viel sich die Kanten des Kontexts ändern</translation>
    </message>
    <message>
        <source>Carving, in all views</source>
        <translation>Abtragen, in allen Ansichten</translation>
    </message>
    <message>
        <source>remove what lies along it, once the button is let go</source>
        <translation>beim Loslassen entfernen, was entlang des Strichs liegt</translation>
    </message>
    <message>
        <source>bend the plane that was laid last</source>
        <translation>die zuletzt gelegte Ebene biegen</translation>
    </message>
    <message>
        <source>A transfer function</source>
        <translation>Transferfunktion</translation>
    </message>
    <message>
        <source>Drag a point, or a trapezoid&apos;s edge, top or inside</source>
        <translation>Punkt ziehen, oder Kante, Oberseite oder Inneres eines Trapezes</translation>
    </message>
    <message>
        <source>move it; with Shift across or up and down alone; Esc takes it back</source>
        <translation>verschieben; mit Umschalt nur quer oder senkrecht; Esc nimmt es zurück</translation>
    </message>
    <message>
        <source>Double-click</source>
        <translation>Doppelklick</translation>
    </message>
    <message>
        <source>add a point, or choose the colour of the point there</source>
        <translation>Punkt hinzufügen, oder die Farbe des Punkts dort wählen</translation>
    </message>
    <message>
        <source>Right click</source>
        <translation>Rechtsklick</translation>
    </message>
    <message>
        <source>colour, delete, and add a point or a trapezoid</source>
        <translation>Farbe, Löschen, und Punkt oder Trapez hinzufügen</translation>
    </message>
    <message>
        <source>Wheel, middle drag</source>
        <translation>Rad, Ziehen mit der mittleren Taste</translation>
    </message>
    <message>
        <source>enlarge the values, and move along them</source>
        <translation>die Werte vergrößern und sich entlang bewegen</translation>
    </message>
    <message>
        <source>Arrows</source>
        <translation>Pfeiltasten</translation>
    </message>
    <message>
        <source>move the point; with Shift ten times as far, with Alt its whole trapezoid</source>
        <translation>Punkt verschieben; mit Umschalt zehnmal so weit, mit Alt sein ganzes Trapez</translation>
    </message>
    <message>
        <source>Page up, Page down, Home, End</source>
        <translation>Bild auf, Bild ab, Pos1, Ende</translation>
    </message>
    <message>
        <source>choose another point</source>
        <translation>einen anderen Punkt wählen</translation>
    </message>
    <message>
        <source>Ins, Del, Return</source>
        <translation>Einfg, Entf, Eingabe</translation>
    </message>
    <message>
        <source>add a point, delete the point, choose its colour</source>
        <translation>Punkt hinzufügen, Punkt löschen, seine Farbe wählen</translation>
    </message>
    <message>
        <source>All views</source>
        <translation>Alle Ansichten</translation>
    </message>
    <message>
        <source>Middle drag</source>
        <translation>Ziehen mit der mittleren Taste</translation>
    </message>
    <message>
        <source>move the picture</source>
        <translation>das Bild verschieben</translation>
    </message>
    <message>
        <source>Right drag, Ctrl+wheel</source>
        <translation>Ziehen mit der rechten Taste, Strg+Rad</translation>
    </message>
    <message>
        <source>a menu for that place</source>
        <translation>Menü zu dieser Stelle</translation>
    </message>
    <message>
        <source>Shift+move</source>
        <translation>Umschalt+Bewegen</translation>
    </message>
    <message>
        <source>crosshair follows the mouse</source>
        <translation>das Fadenkreuz folgt der Maus</translation>
    </message>
    <message>
        <source>show this view alone; Esc shows all</source>
        <translation>nur diese Ansicht zeigen; Esc zeigt alle</translation>
    </message>
    <message>
        <source>Shift+wheel</source>
        <translation>Umschalt+Rad</translation>
    </message>
    <message>
        <source>thickness of the slab, from the slice alone to 100 mm</source>
        <translation>Dicke des Schichtpakets, von der Schicht allein bis 100 mm</translation>
    </message>
    <message>
        <source>The crosshair&apos;s lines, on the slices</source>
        <translation>Linien des Fadenkreuzes, auf den Schichten</translation>
    </message>
    <message>
        <source>Drag a ball</source>
        <translation>Kugel ziehen</translation>
    </message>
    <message>
        <source>turn the plane of that colour</source>
        <translation>die Ebene dieser Farbe drehen</translation>
    </message>
    <message>
        <source>hold its line to rows, columns and diagonals</source>
        <translation>ihre Linie an Zeilen, Spalten und Diagonalen halten</translation>
    </message>
    <message>
        <source>turn both planes</source>
        <translation>beide Ebenen drehen</translation>
    </message>
    <message>
        <source>Outlines of the slices, in the 3-D views</source>
        <translation>Umrisse der Schichten, in den 3-D-Ansichten</translation>
    </message>
    <message>
        <source>Home, End</source>
        <translation>Pos1, Ende</translation>
    </message>
    <message>
        <source>first and last slice</source>
        <translation>erste und letzte Schicht</translation>
    </message>
    <message>
        <source>move the picture; on the body only while clicks choose no focus (Focus menu)</source>
        <translation>das Bild verschieben; auf dem Körper nur, solange Klicks keinen Fokus wählen (Menü Fokus)</translation>
    </message>
    <message>
        <source>What an archive holds</source>
        <translation>Was ein Archiv enthält</translation>
    </message>
    <message>
        <source>Double-click, Return</source>
        <translation>Doppelklick, Eingabe</translation>
    </message>
    <message>
        <source>retrieve the study or series, and open it once it is whole</source>
        <translation>die Studie oder Serie abrufen und öffnen, sobald sie vollständig ist</translation>
    </message>
    <message>
        <source>Drag onto a view</source>
        <translation>Auf eine Ansicht ziehen</translation>
    </message>
    <message>
        <source>retrieve what is selected, and open it once it is whole</source>
        <translation>das Ausgewählte abrufen und öffnen, sobald es vollständig ist</translation>
    </message>
    <message>
        <source>DICOM tags and label table</source>
        <translation>DICOM-Attribute und Labeltabelle</translation>
    </message>
    <message>
        <source>Click on a label</source>
        <translation>Klick auf ein Label</translation>
    </message>
    <message>
        <source>crosshair into it</source>
        <translation>Fadenkreuz hinein</translation>
    </message>
    <message>
        <source>Ctrl+C, right click</source>
        <translation>Strg+C, Rechtsklick</translation>
    </message>
    <message>
        <source>copy the selected rows, or a value</source>
        <translation>die gewählten Zeilen oder einen Wert kopieren</translation>
    </message>
    <message>
        <source>Key images</source>
        <translation>Schlüsselbilder</translation>
    </message>
    <message>
        <source>Click, Return</source>
        <translation>Klick, Eingabe</translation>
    </message>
    <message>
        <source>go back to it</source>
        <translation>dorthin zurück</translation>
    </message>
    <message>
        <source>F2</source>
        <translation>F2</translation>
    </message>
    <message>
        <source>rename it</source>
        <translation>umbenennen</translation>
    </message>
    <message>
        <source>draw the measure or arrow whose tool is chosen, then type an arrow&apos;s text; Esc ends it</source>
        <translation>die Messung oder den Pfeil zeichnen, dessen Werkzeug gewählt ist, dann den Text des Pfeils tippen; Esc beendet es</translation>
    </message>
    <message>
        <source>Click, as a text&apos;s tool is chosen</source>
        <translation>Klick, wenn das Textwerkzeug gewählt ist</translation>
    </message>
    <message>
        <source>place a text, and type it</source>
        <translation>einen Text setzen und tippen</translation>
    </message>
    <message>
        <source>copy and delete; change the text of a mark</source>
        <translation>kopieren und löschen; den Text einer Markierung ändern</translation>
    </message>
    <message>
        <source>The path of the curved reformat, on the slices</source>
        <translation>Pfad der gekrümmten Reformatierung, auf den Schichten</translation>
    </message>
    <message>
        <source>Clicks, as it is being drawn</source>
        <translation>Klicks, solange er gezeichnet wird</translation>
    </message>
    <message>
        <source>add points; Enter or a double click ends it, Esc drops it</source>
        <translation>Punkte hinzufügen; Eingabe oder Doppelklick beendet ihn, Esc verwirft ihn</translation>
    </message>
    <message>
        <source>Backspace</source>
        <translation>Rücktaste</translation>
    </message>
    <message>
        <source>take the last point away</source>
        <translation>den letzten Punkt wegnehmen</translation>
    </message>
    <message>
        <source>The pictures of the curved reformat</source>
        <translation>Bilder der gekrümmten Reformatierung</translation>
    </message>
    <message>
        <source>crosshair to that place of the path</source>
        <translation>Fadenkreuz an diese Stelle des Pfades</translation>
    </message>
    <message>
        <source>Wheel, arrows, Page, Home and End keys</source>
        <translation>Rad, Pfeil-, Bild-, Pos1- und Ende-Tasten</translation>
    </message>
    <message>
        <source>move along the path</source>
        <translation>am Pfad entlanggehen</translation>
    </message>
    <message>
        <source>Drag a point</source>
        <translation>Punkt ziehen</translation>
    </message>
    <message>
        <source>move it</source>
        <translation>ihn verschieben</translation>
    </message>
</context>
<context>
    <name>Fidelity</name>
    <message>
        <source>slices are shown up to %1 mm from their true places</source>
        <translation>Schichten liegen bis zu %1 mm neben ihren wahren Orten</translation>
    </message>
    <message>
        <source>tilt is made straight: %1 slices are resampled onto %2 planes</source>
        <translation>Kippung ausgeglichen: %1 Schichten wurden auf %2 Ebenen umgerechnet</translation>
    </message>
    <message>
        <source>%1 slices are resampled onto %2 even planes</source>
        <translation>%1 Schichten wurden auf %2 gleichmäßige Ebenen umgerechnet</translation>
    </message>
    <message>
        <source>this plane was not scanned: it is interpolated across a gap</source>
        <translation>diese Ebene wurde nicht aufgenommen: sie ist über eine Lücke interpoliert</translation>
    </message>
    <message>
        <source>%1 of %2 planes are interpolated across gaps</source>
        <translation>%1 von %2 Ebenen sind über Lücken interpoliert</translation>
    </message>
    <message>
        <source>places or sizes are assumed, because the file does not give them</source>
        <translation>Orte oder Größen sind angenommen, weil die Datei sie nicht angibt</translation>
    </message>
    <message>
        <source>some values are outside of what the file&apos;s header allows</source>
        <translation>manche Werte liegen außerhalb dessen, was der Header erlaubt</translation>
    </message>
    <message>
        <source>values are rounded to the precision of the program&apos;s numbers</source>
        <translation>Werte sind auf die Genauigkeit der Zahlen des Programms gerundet</translation>
    </message>
    <message>
        <source>slices are missing</source>
        <translation>Schichten fehlen</translation>
    </message>
    <message>
        <source>files were left out</source>
        <translation>Dateien wurden ausgelassen</translation>
    </message>
    <message>
        <source>slices of one place were left out</source>
        <translation>Schichten desselben Orts wurden ausgelassen</translation>
    </message>
    <message>
        <source>slices of another size or direction are shown as the first one</source>
        <translation>Schichten anderer Größe oder Richtung werden wie die erste gezeigt</translation>
    </message>
    <message>
        <source>the data differ from those of the session</source>
        <translation>die Daten weichen von denen der Sitzung ab</translation>
    </message>
    <message>
        <source>1 file</source>
        <translation>1 Datei</translation>
    </message>
    <message>
        <source>%1 files</source>
        <translation>%1 Dateien</translation>
    </message>
    <message>
        <source>a part of the volume is clipped, by 1 plane</source>
        <translation>ein Teil des Volumens ist durch 1 Ebene beschnitten</translation>
    </message>
    <message>
        <source>a part of the volume is clipped, by %1 planes</source>
        <translation>ein Teil des Volumens ist durch %1 Ebenen beschnitten</translation>
    </message>
    <message>
        <source>1 structure is hidden</source>
        <translation>1 Struktur ist verborgen</translation>
    </message>
    <message>
        <source>%1 structures are hidden</source>
        <translation>%1 Strukturen sind verborgen</translation>
    </message>
    <message>
        <source>a part of the volume is carved away</source>
        <translation>ein Teil des Volumens ist abgetragen</translation>
    </message>
    <message>
        <source>the scanner&apos;s table is left out</source>
        <translation>der Tisch des Scanners ist weggelassen</translation>
    </message>
    <message>
        <source>parts are moved apart: distances between them do not hold</source>
        <translation>Teile sind auseinandergerückt: Abstände zwischen ihnen gelten nicht</translation>
    </message>
    <message>
        <source>a layer is rolled up: distances on it do not hold</source>
        <translation>eine Schicht ist aufgerollt: Abstände auf ihr gelten nicht</translation>
    </message>
    <message>
        <source>values are smoothed between voxels</source>
        <translation>Werte sind zwischen den Voxeln geglättet</translation>
    </message>
    <message>
        <source>values are smoothed over several voxels</source>
        <translation>Werte sind über mehrere Voxel geglättet</translation>
    </message>
    <message>
        <source>values between voxels follow a cubic spline, which may overshoot</source>
        <translation>Werte zwischen Voxeln folgen einem kubischen Spline, der überschwingen kann</translation>
    </message>
    <message>
        <source>the surface of labels is smoothed lightly</source>
        <translation>die Oberfläche der Labels ist leicht geglättet</translation>
    </message>
    <message>
        <source>the surface of labels is smoothed strongly</source>
        <translation>die Oberfläche der Labels ist stark geglättet</translation>
    </message>
    <message>
        <source>a draft while something moves, %1 % of the size</source>
        <translation>ein Entwurf in Bewegung, %1 % der Größe</translation>
    </message>
    <message>
        <source>the sampling error has no bound (quality: %1)</source>
        <translation>der Abtastfehler hat keine Schranke (Qualität: %1)</translation>
    </message>
    <message>
        <source>the sampling error is at most %1/255</source>
        <translation>der Abtastfehler beträgt höchstens %L1/255</translation>
    </message>
    <message>
        <source>not verified</source>
        <translation>nicht geprüft</translation>
    </message>
    <message>
        <source>verified: %1</source>
        <translation>geprüft: %1</translation>
    </message>
    <message>
        <source>not yet what was asked for</source>
        <translation>noch nicht das Verlangte</translation>
    </message>
    <message>
        <source>faithful</source>
        <translation>getreu</translation>
    </message>
    <message>
        <source>bounded</source>
        <translation>begrenzt</translation>
    </message>
    <message>
        <source>approximate</source>
        <translation>angenähert</translation>
    </message>
    <message>
        <source>altered</source>
        <translation>verändert</translation>
    </message>
    <message>
        <source>a slab: only the highest value of %1 mm shows</source>
        <translation>ein Schichtpaket: nur der höchste Wert von %1 mm ist zu sehen</translation>
    </message>
    <message>
        <source>a slab: only the lowest value of %1 mm shows</source>
        <translation>ein Schichtpaket: nur der niedrigste Wert von %1 mm ist zu sehen</translation>
    </message>
    <message>
        <source>a slab: the mean of %1 mm shows</source>
        <translation>ein Schichtpaket: das Mittel von %1 mm ist zu sehen</translation>
    </message>
    <message>
        <source>values between voxels are interpolated linearly</source>
        <translation>Werte zwischen Voxeln sind linear interpoliert</translation>
    </message>
</context>
<context>
    <name>FramePacer</name>
    <message>
        <source>draft</source>
        <translation>Entwurf</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>normal</translation>
    </message>
    <message>
        <source>error ≤ %1/255</source>
        <translation>Fehler ≤ %L1/255</translation>
    </message>
</context>
<context>
    <name>FunctionTarget</name>
    <message>
        <source>Focus</source>
        <translation>Fokus</translation>
    </message>
    <message>
        <source>Transfer function</source>
        <translation>Transferfunktion</translation>
    </message>
    <message>
        <source>Context</source>
        <translation>Kontext</translation>
    </message>
    <message>
        <source>Focus: %1</source>
        <translation>Fokus: %1</translation>
    </message>
</context>
<context>
    <name>GlSupport</name>
    <message>
        <source>Qt&apos;s offscreen platform has no OpenGL; unset QT_QPA_PLATFORM.</source>
        <translation>Qts Offscreen-Plattform hat kein OpenGL; QT_QPA_PLATFORM nicht setzen.</translation>
    </message>
    <message>
        <source>No OpenGL context can be made on this display. Install the graphics driver, or Mesa&apos;s software renderer (Debian: libgl1-mesa-dri); on a remote desktop, start Fenestra there.</source>
        <translation>Auf diesem Bildschirm kann kein OpenGL-Kontext entstehen. Installieren Sie den Grafiktreiber oder Mesas Software-Renderer (Debian: libgl1-mesa-dri); bei einem entfernten Desktop starten Sie Fenestra dort.</translation>
    </message>
    <message>
        <source>OpenGL cannot draw on this display. On a remote desktop, use one with GLX.</source>
        <translation>OpenGL kann auf diesem Bildschirm nicht zeichnen. Nehmen Sie einen entfernten Desktop mit GLX.</translation>
    </message>
    <message>
        <source>%1 (LIBGL_ALWAYS_SOFTWARE=1 in the environment selects it).</source>
        <translation>%1 (LIBGL_ALWAYS_SOFTWARE=1 in der Umgebung wählt ihn).</translation>
    </message>
</context>
<context>
    <name>LabelName</name>
    <message>
        <source>label %1</source>
        <translation>Label %1</translation>
    </message>
</context>
<context>
    <name>Measure</name>
    <message>
        <source>Distance</source>
        <translation>Strecke</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>Ellipse</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rechteck</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%L1 mm</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%L1°</translation>
    </message>
    <message>
        <source>Mean %1 %2</source>
        <translation>Mittel %L1 %2</translation>
    </message>
    <message>
        <source>SD %1</source>
        <translation>SD %L1</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>%1 mm²</source>
        <translation>%L1 mm²</translation>
    </message>
    <message>
        <source>%1 cm²</source>
        <translation>%L1 cm²</translation>
    </message>
    <message>
        <source>Arrow</source>
        <translation>Pfeil</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
</context>
<context>
    <name>MeasureMenu</name>
    <message>
        <source>Copy this measure</source>
        <translation>Diese Messung kopieren</translation>
    </message>
    <message>
        <source>Copy all as a table (CSV)</source>
        <translation>Alle als Tabelle kopieren (CSV)</translation>
    </message>
    <message>
        <source>Delete this measure</source>
        <translation>Diese Messung löschen</translation>
    </message>
    <message>
        <source>Delete all measures</source>
        <translation>Alle Messungen löschen</translation>
    </message>
    <message>
        <source>Text of the mark</source>
        <translation>Text der Markierung</translation>
    </message>
    <message>
        <source>Pictures and sessions hold it: name no patient.</source>
        <translation>Bilder und Sitzungen enthalten ihn: nennen Sie keinen Patienten.</translation>
    </message>
    <message>
        <source>Change the text…</source>
        <translation>Text ändern…</translation>
    </message>
</context>
<context>
    <name>MethodRows</name>
    <message>
        <source>Levels</source>
        <translation>Stufen</translation>
    </message>
    <message>
        <source>rim</source>
        <extracomment>before the number that says how thin the line around a lens is</extracomment>
        <translation>Rand</translation>
    </message>
    <message>
        <source>A</source>
        <comment>axial</comment>
        <translation>A</translation>
    </message>
    <message>
        <source>S</source>
        <comment>sagittal</comment>
        <translation>S</translation>
    </message>
    <message>
        <source>C</source>
        <comment>coronal</comment>
        <translation>K</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Schichten</translation>
    </message>
</context>
<context>
    <name>Number</name>
    <message>
        <source>%1 ml</source>
        <translation>%L1 ml</translation>
    </message>
    <message>
        <source>%1 l</source>
        <translation>%L1 l</translation>
    </message>
</context>
<context>
    <name>Overlay</name>
    <message>
        <source>Axial</source>
        <translation>Axial</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagittal</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>Koronal</translation>
    </message>
</context>
<context>
    <name>Panels</name>
    <message>
        <source>Focus</source>
        <translation>Fokus</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Kameras</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Pinsel</translation>
    </message>
    <message>
        <source>Clipping</source>
        <translation>Beschnitt</translation>
    </message>
    <message>
        <source>Context</source>
        <translation>Kontext</translation>
    </message>
    <message>
        <source>Context edges</source>
        <translation>Kontextkanten</translation>
    </message>
    <message>
        <source>Cutaway</source>
        <translation>Freischnitt</translation>
    </message>
    <message>
        <source>Series</source>
        <translation>Serien</translation>
    </message>
    <message>
        <source>DICOM tags</source>
        <translation>DICOM-Attribute</translation>
    </message>
    <message>
        <source>Ctrl+T</source>
        <translation>Ctrl+T</translation>
    </message>
    <message>
        <source>Label table</source>
        <translation>Labeltabelle</translation>
    </message>
    <message>
        <source>Ctrl+Shift+T</source>
        <translation>Ctrl+Shift+T</translation>
    </message>
    <message>
        <source>Key images</source>
        <translation>Schlüsselbilder</translation>
    </message>
    <message>
        <source>Ctrl+Shift+D</source>
        <translation>Ctrl+Shift+D</translation>
    </message>
    <message>
        <source>Curved reformat</source>
        <translation>Gekrümmte Reformatierung</translation>
    </message>
    <message>
        <source>Ctrl+Shift+R</source>
        <translation>Ctrl+Shift+R</translation>
    </message>
</context>
<context>
    <name>Patient</name>
    <message>
        <source>ID %1</source>
        <translation>ID %1</translation>
    </message>
    <message>
        <source>born %1</source>
        <translation>geboren %1</translation>
    </message>
</context>
<context>
    <name>PlacementForm</name>
    <message>
        <source>From the side of the body that the focus is nearer to, rather than through the body, where both show about as much</source>
        <translation>Von der Körperseite, der der Fokus näher liegt, statt durch den Körper hindurch, wo beide etwa gleich viel zeigen</translation>
    </message>
</context>
<context>
    <name>PlaneMenu</name>
    <message>
        <source>Slab of the %1 slice</source>
        <translation>Schichtpaket der Schicht: %1</translation>
    </message>
    <message>
        <source>Thickness in mm, half of it to each side; 0 is the slice alone:</source>
        <translation>Dicke in mm, je die Hälfte nach beiden Seiten; 0 ist die Schicht allein:</translation>
    </message>
    <message>
        <source>Off: the slice alone</source>
        <translation>Aus: die Schicht allein</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%L1 mm</translation>
    </message>
    <message>
        <source>Other: %1 mm…</source>
        <translation>Andere: %1 mm…</translation>
    </message>
    <message>
        <source>Other…</source>
        <translation>Andere…</translation>
    </message>
    <message>
        <source>Maximum (MIP)</source>
        <translation>Maximum (MIP)</translation>
    </message>
    <message>
        <source>Minimum (MinIP)</source>
        <translation>Minimum (MinIP)</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>All slices as this one</source>
        <translation>Alle Schichten wie diese</translation>
    </message>
    <message>
        <source>Slice faces C1</source>
        <translation>Schicht zu C1 gewandt</translation>
    </message>
    <message>
        <source>Slice faces C2</source>
        <translation>Schicht zu C2 gewandt</translation>
    </message>
    <message>
        <source>Slab</source>
        <translation>Schichtpaket</translation>
    </message>
    <message>
        <source>Reset this slice&apos;s plane</source>
        <translation>Ebene dieser Schicht zurücksetzen</translation>
    </message>
    <message>
        <source>Reset all planes</source>
        <translation>Alle Ebenen zurücksetzen</translation>
    </message>
</context>
<context>
    <name>PlaneTool</name>
    <message>
        <source>%1°</source>
        <translation>%L1°</translation>
    </message>
</context>
<context>
    <name>Reader</name>
    <message>
        <source>the scanner&apos;s table is left out of 3-D pictures; slices show it</source>
        <translation>der Untersuchungstisch ist in 3-D-Bildern ausgelassen; die Schichten zeigen ihn</translation>
    </message>
    <message>
        <source>the file names no modality; its values (%1 to %2) are taken for Hounsfield units of a CT</source>
        <translation>die Datei nennt keine Modalität; ihre Werte (%1 bis %2) gelten als Hounsfield-Einheiten einer CT</translation>
    </message>
    <message>
        <source>the file stores no orientation; its axes are taken as right, anterior, superior</source>
        <translation>die Datei speichert keine Orientierung; ihre Achsen gelten als rechts, vorn, oben</translation>
    </message>
    <message>
        <source>the file does not say where the slice lies in the patient</source>
        <translation>die Datei sagt nicht, wo die Schicht im Patienten liegt</translation>
    </message>
    <message>
        <source>the file does not say where its slices lie in the patient; their Slice Location gives their order and a distance of %1 mm, the place is a guess</source>
        <translation>die Datei sagt nicht, wo ihre Schichten im Patienten liegen; ihre Slice Location gibt die Reihenfolge und einen Abstand von %1 mm, der Ort ist geraten</translation>
    </message>
    <message>
        <source>the file does not say where its slices lie in the patient; they are shown in their stored order, at a distance that is a guess (%1 mm, %2)</source>
        <translation>die Datei sagt nicht, wo ihre Schichten im Patienten liegen; sie werden in gespeicherter Reihenfolge gezeigt, in einem geratenen Abstand (%1 mm, %2)</translation>
    </message>
    <message>
        <source>no pixel spacing is given; 1 mm is assumed</source>
        <translation>kein Pixelabstand ist angegeben; 1 mm wird angenommen</translation>
    </message>
    <message>
        <source>the pixel spacing is the detector&apos;s; distances in the patient are smaller</source>
        <translation>der Pixelabstand ist der des Detektors; Abstände im Patienten sind kleiner</translation>
    </message>
    <message>
        <source>its header has no ElementSpacing; 1 mm is assumed</source>
        <translation>ihr Kopf hat kein ElementSpacing; 1 mm wird angenommen</translation>
    </message>
    <message>
        <source>its header has no spacings; 1 mm is assumed</source>
        <translation>ihr Kopf hat keine Voxelabstände; 1 mm wird angenommen</translation>
    </message>
    <message>
        <source>the file holds %1 volumes (time points or layers); number %2 is shown</source>
        <translation>die Datei enthält %1 Volumen (Zeitpunkte oder Lagen); Nummer %2 wird gezeigt</translation>
    </message>
    <message>
        <source>all %1 frames lie at one position (time points or repeats, no deeper volume%2); each forms a volume of its own: number %3 is shown</source>
        <translation>alle %1 Bilder liegen an einem Ort (Zeitpunkte oder Wiederholungen, kein tieferes Volumen%2); jedes bildet ein eigenes Volumen: Nummer %3 wird gezeigt</translation>
    </message>
    <message>
        <source>%1 frames lie at each position (time points or repeats, no deeper volume%2); each forms a volume of its own: number %3 is shown</source>
        <translation>an jedem Ort liegen %1 Bilder (Zeitpunkte oder Wiederholungen, kein tieferes Volumen%2); jedes bildet ein eigenes Volumen: Nummer %3 wird gezeigt</translation>
    </message>
    <message>
        <source>; told apart by %1</source>
        <translation>; unterschieden durch %1</translation>
    </message>
    <message>
        <source>the slices are tilted by %1 degrees against the direction they are stacked in (%2 mm sideways from slice to slice)</source>
        <translation>die Schichten sind um %1 Grad gegen ihre Stapelrichtung geneigt (%2 mm seitlich von Schicht zu Schicht)</translation>
    </message>
    <message>
        <source>%1 missing: neighbours lie %2 mm apart, but up to %3 mm between the files named</source>
        <translation>%1 fehlen: Nachbarn liegen %2 mm auseinander, zwischen den genannten Dateien aber bis zu %3 mm</translation>
    </message>
    <message>
        <source>the slices lie between %1 mm and %2 mm apart</source>
        <translation>die Schichten liegen zwischen %1 mm und %2 mm auseinander</translation>
    </message>
    <message>
        <source>%1 shifted sideways by up to %2 mm from the line that the first and the last one lie on</source>
        <translation>%1 seitlich um bis zu %2 mm gegen die Linie verschoben, auf der die erste und die letzte liegen</translation>
    </message>
    <message>
        <source>%1 with other directions or pixel spacing than the first; shown with those of the first, pixels lie up to %2 mm from their places</source>
        <translation>%1 mit anderen Richtungen oder anderem Pixelabstand als die erste; gezeigt wie die erste, liegen Pixel bis zu %2 mm neben ihrem Ort</translation>
    </message>
    <message>
        <source>the volume is sheared, so that every slice lies where it was scanned</source>
        <translation>das Volumen ist geschert, sodass jede Schicht liegt, wo sie aufgenommen wurde</translation>
    </message>
    <message>
        <source>all slices are shown %1 mm apart, up to %2 mm from where they were scanned</source>
        <translation>alle Schichten werden %1 mm auseinander gezeigt, bis zu %2 mm neben dem Ort der Aufnahme</translation>
    </message>
    <message>
        <source>%1; %2 of the voxels lie outside of what was scanned and hold the least value, %3</source>
        <translation>%1; %2 der Voxel liegen außerhalb des Aufgenommenen und haben den kleinsten Wert, %3</translation>
    </message>
    <message>
        <source>%1; %2 in gaps wider than %3 mm is interpolated across the gap</source>
        <translation>%1; %2 in einer Lücke von über %3 mm ist über die Lücke interpoliert</translation>
    </message>
    <message>
        <source>%1; %2 in gaps wider than %3 mm are interpolated across the gap</source>
        <translation>%1; %2 in Lücken von über %3 mm sind über die Lücke interpoliert</translation>
    </message>
    <message>
        <source>%1 (evenly spread they would lie up to %2 mm from their places)</source>
        <translation>%1 (gleichmäßig verteilt lägen sie bis zu %2 mm neben ihrem Ort)</translation>
    </message>
    <message>
        <source>%1, with nothing displaced</source>
        <translation>%1, wobei nichts verschoben ist</translation>
    </message>
    <message>
        <source>%1, displaced by up to %2 mm</source>
        <translation>%1, um bis zu %2 mm verschoben</translation>
    </message>
    <message>
        <source>%1, sheared as they were scanned</source>
        <translation>%1, geschert wie aufgenommen</translation>
    </message>
    <message>
        <source>linear interpolation places the slices on %1 planes %2 mm apart</source>
        <translation>lineare Interpolation legt die Schichten auf %1 Ebenen im Abstand von %2 mm</translation>
    </message>
    <message>
        <source>cubic interpolation places the slices on %1 planes %2 mm apart</source>
        <translation>kubische Interpolation legt die Schichten auf %1 Ebenen im Abstand von %2 mm</translation>
    </message>
    <message>
        <source>%1 left out: the same images (SOP instances) as in other files</source>
        <translation>%1 ausgelassen: dieselben Bilder (SOP-Instanzen) wie in anderen Dateien</translation>
    </message>
    <message>
        <source>%1 of the folder left out: not DICOM</source>
        <translation>%1 des Ordners ausgelassen: kein DICOM</translation>
    </message>
    <message>
        <source>%1 left out, unreadable (the first: %2)</source>
        <translation>%1 ausgelassen, unlesbar (die erste: %2)</translation>
    </message>
    <message>
        <source>%1 listed in the DICOMDIR missing</source>
        <translation>%1 aus dem DICOMDIR fehlen</translation>
    </message>
    <message>
        <source>%1 left out, at positions that other slices have already</source>
        <translation>%1 ausgelassen, an Orten, die andere Schichten schon haben</translation>
    </message>
    <message>
        <source>%1 of the series put into volumes of their own: %2</source>
        <translation>%1 der Serie in eigene Volumen gelegt: %2</translation>
    </message>
    <message>
        <source>another size or pixel spacing</source>
        <translation>andere Größe oder anderer Pixelabstand</translation>
    </message>
    <message>
        <source>another orientation</source>
        <translation>andere Orientierung</translation>
    </message>
    <message>
        <source>another frame of reference, frame type or stack</source>
        <translation>anderes Bezugssystem, anderer Bildtyp oder Stapel</translation>
    </message>
    <message>
        <source>%1 slices have a Series UID each; they agree in study and kind and lie evenly, and are taken for one series</source>
        <translation>%1 Schichten haben je eine eigene Serien-UID; sie stimmen in Studie und Art überein und liegen gleichmäßig, daher gelten sie als eine Serie</translation>
    </message>
    <message>
        <source>%1 left out: %2</source>
        <translation>%1 ausgelassen: %2</translation>
    </message>
    <message>
        <source>the focus has no voxels in this volume</source>
        <translation>der Fokus hat in diesem Volumen keine Voxel</translation>
    </message>
    <message>
        <source>the volume %1 is not what it was when the session was saved</source>
        <translation>das Volumen %1 ist nicht mehr, was es beim Speichern der Sitzung war</translation>
    </message>
    <message>
        <source>the label map %1 is not what it was when the session was saved</source>
        <translation>die Labelkarte %1 ist nicht mehr, was sie beim Speichern der Sitzung war</translation>
    </message>
    <message>
        <source>the volume was found at %1, no longer at %2</source>
        <translation>das Volumen wurde in %1 gefunden, nicht mehr in %2</translation>
    </message>
    <message>
        <source>the label map was found at %1, no longer at %2</source>
        <translation>die Labelkarte wurde in %1 gefunden, nicht mehr in %2</translation>
    </message>
    <message>
        <source>%1 (in %2 of %3 slices)</source>
        <translation>%1 (in %2 von %3 Schichten)</translation>
    </message>
    <message>
        <source>%1 file</source>
        <translation>%1 Datei</translation>
    </message>
    <message>
        <source>%1 files</source>
        <translation>%1 Dateien</translation>
    </message>
    <message>
        <source>%1 slice</source>
        <translation>%1 Schicht</translation>
    </message>
    <message>
        <source>%1 slices</source>
        <translation>%1 Schichten</translation>
    </message>
    <message>
        <source>%1 plane</source>
        <translation>%1 Ebene</translation>
    </message>
    <message>
        <source>%1 planes</source>
        <translation>%1 Ebenen</translation>
    </message>
</context>
<context>
    <name>Region</name>
    <message>
        <source>Its border is clear: values change by %1 there.</source>
        <translation>Ihre Grenze ist klar: dort ändern sich die Werte um %1.</translation>
    </message>
    <message>
        <source>Its border is fair: values change by %1 there.</source>
        <translation>Ihre Grenze ist mäßig: dort ändern sich die Werte um %1.</translation>
    </message>
    <message>
        <source>It is doubtful: nearly any other tolerance makes it far larger or smaller. Check its outline on the slices.</source>
        <translation>Sie ist zweifelhaft: fast jede andere Toleranz macht sie viel größer oder kleiner. Prüfen Sie ihren Umriss auf den Schichten.</translation>
    </message>
    <message>
        <source>It is doubtful: another region here, far larger or smaller, is nearly as clear. Check its outline on the slices.</source>
        <translation>Sie ist zweifelhaft: eine andere Region an dieser Stelle, viel größer oder kleiner, ist fast so klar. Prüfen Sie ihren Umriss auf den Schichten.</translation>
    </message>
    <message>
        <source>It is doubtful: it spreads from a thin part at the click into a thicker one. Check its outline on the slices.</source>
        <translation>Sie ist zweifelhaft: sie breitet sich von einem dünnen Teil beim Klick in einen dickeren aus. Prüfen Sie ihren Umriss auf den Schichten.</translation>
    </message>
    <message>
        <source>It is doubtful: it is a flat tube, as two vessels side by side are. Check its outline on the slices.</source>
        <translation>Sie ist zweifelhaft: sie ist eine flache Röhre, wie zwei Gefäße nebeneinander. Prüfen Sie ihren Umriss auf den Schichten.</translation>
    </message>
    <message>
        <source>It is doubtful: values change by only %1 along its border. Check its outline on the slices.</source>
        <translation>Sie ist zweifelhaft: an ihrer Grenze ändern sich die Werte nur um %1. Prüfen Sie ihren Umriss auf den Schichten.</translation>
    </message>
    <message>
        <source>the left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>the right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>the back</source>
        <translation>hinten</translation>
    </message>
    <message>
        <source>the front</source>
        <translation>vorn</translation>
    </message>
    <message>
        <source>the head</source>
        <translation>zum Kopf</translation>
    </message>
    <message>
        <source>the feet</source>
        <translation>zu den Füßen</translation>
    </message>
    <message>
        <source>on all sides</source>
        <translation>nach allen Seiten</translation>
    </message>
    <message>
        <source>towards %1</source>
        <translation>Richtung: %1</translation>
    </message>
    <message>
        <source>towards %1 and %2</source>
        <translation>Richtung: %1 und %2</translation>
    </message>
    <message>
        <source>Values: %1 ± %2.</source>
        <translation>Werte: %1 ± %2.</translation>
    </message>
    <message>
        <source>Next leak: at %1 to %2, %3.</source>
        <translation>Nächstes Auslaufen: bei %1 auf %2, %3.</translation>
    </message>
</context>
<context>
    <name>RegionBall</name>
    <message>
        <source>%1 mm</source>
        <translation>%L1 mm</translation>
    </message>
</context>
<context>
    <name>RenderProblem</name>
    <message>
        <source>The graphics driver refuses a part of Fenestra (%1). Update the driver, or start Fenestra with LIBGL_ALWAYS_SOFTWARE=1 in the environment.</source>
        <translation>Der Grafiktreiber lehnt einen Teil von Fenestra ab (%1). Aktualisieren Sie den Treiber, oder starten Sie Fenestra mit LIBGL_ALWAYS_SOFTWARE=1 in der Umgebung.</translation>
    </message>
    <message>
        <source>There is not enough memory for this picture. Close other programs, or open a smaller volume.</source>
        <translation>Für dieses Bild fehlt Speicher. Schließen Sie andere Programme, oder öffnen Sie ein kleineres Volumen.</translation>
    </message>
</context>
<context>
    <name>Results</name>
    <message>
        <source>Focus</source>
        <translation>Fokus</translation>
    </message>
    <message>
        <source>Measures</source>
        <translation>Messungen</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>Labels</translation>
    </message>
    <message>
        <source>Segments of the measures</source>
        <translation>Segmente der Messungen</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Key images</source>
        <translation>Schlüsselbilder</translation>
    </message>
</context>
<context>
    <name>Series</name>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>every %1</source>
        <translation>alle %1</translation>
    </message>
    <message>
        <source>%1, every %2</source>
        <translation>%1, alle %2</translation>
    </message>
    <message>
        <source>time point %1 of %2</source>
        <translation>Zeitpunkt %1 von %2</translation>
    </message>
    <message>
        <source>Series without a name</source>
        <translation>Serie ohne Namen</translation>
    </message>
    <message>
        <source>Series %1</source>
        <translation>Serie %1</translation>
    </message>
    <message>
        <source>Study %1</source>
        <translation>Studie %1</translation>
    </message>
</context>
<context>
    <name>ServerEntry</name>
    <message>
        <source>The server&apos;s AE title has 1 to 16 letters and digits; its administrator knows it.</source>
        <translation>Der AE-Titel des Servers hat 1 bis 16 Buchstaben und Ziffern; sein Administrator kennt ihn.</translation>
    </message>
    <message>
        <source>Our AE title has 1 to 16 letters and digits; the server must know it.</source>
        <translation>Der eigene AE-Titel hat 1 bis 16 Buchstaben und Ziffern; der Server muss ihn kennen.</translation>
    </message>
    <message>
        <source>The host is a name or an address, such as pacs.hospital or 192.168.1.5.</source>
        <translation>Der Host ist ein Name oder eine Adresse, etwa pacs.hospital oder 192.168.1.5.</translation>
    </message>
    <message>
        <source>C-MOVE needs a port of ours that is entered at the server.</source>
        <translation>C-MOVE braucht einen eigenen Port, der beim Server eingetragen ist.</translation>
    </message>
    <message>
        <source>TLS needs the file of the certificates that may sign the server&apos;s, in PEM.</source>
        <translation>TLS braucht die PEM-Datei der Zertifikate, die das des Servers signieren dürfen.</translation>
    </message>
    <message>
        <source>Our certificate needs its key, and the key its certificate.</source>
        <translation>Das eigene Zertifikat braucht seinen Schlüssel, und der Schlüssel sein Zertifikat.</translation>
    </message>
    <message>
        <source>The address is that of DICOMweb&apos;s root, such as https://pacs.hospital/dicom-web.</source>
        <translation>Die Adresse ist die der DICOMweb-Wurzel, etwa https://pacs.hospital/dicom-web.</translation>
    </message>
    <message>
        <source>A login with a password needs the user&apos;s name.</source>
        <translation>Eine Anmeldung mit Passwort braucht den Benutzernamen.</translation>
    </message>
    <message>
        <source>This desktop has no key ring that runs, so the password or token is not kept.</source>
        <translation>Auf diesem Desktop läuft kein Schlüsselbund, daher wird das Passwort oder Token nicht aufbewahrt.</translation>
    </message>
    <message>
        <source>The key ring was not opened, so the password or token is neither read nor kept.</source>
        <translation>Der Schlüsselbund wurde nicht geöffnet, daher wird das Passwort oder Token weder gelesen noch aufbewahrt.</translation>
    </message>
    <message>
        <source>The key ring cannot be used: %1</source>
        <translation>Der Schlüsselbund kann nicht benutzt werden: %1</translation>
    </message>
    <message>
        <source>Waiting for the key ring of the desktop…</source>
        <translation>Warten auf den Schlüsselbund des Desktops…</translation>
    </message>
    <message>
        <source>Go on without</source>
        <translation>Ohne ihn fortfahren</translation>
    </message>
    <message>
        <source>The key ring was not waited for.</source>
        <translation>Auf den Schlüsselbund wurde nicht gewartet.</translation>
    </message>
</context>
<context>
    <name>Settings</name>
    <message>
        <source>Light theme</source>
        <translation>Helles Design</translation>
    </message>
    <message>
        <source>Light colours around the pictures, for bright rooms</source>
        <translation>Helle Farben um die Bilder, für helle Räume</translation>
    </message>
    <message>
        <source>Animate the cameras</source>
        <translation>Kamerafahrten</translation>
    </message>
    <message>
        <source>Cameras fly to where they are placed instead of jumping there</source>
        <translation>Kameras fliegen an ihren Platz, statt zu springen</translation>
    </message>
    <message>
        <source>While something moves</source>
        <translation>Während sich etwas bewegt</translation>
    </message>
    <message>
        <source>Pictures a second to aim at: more of them are smaller on a slow machine. At rest they always have full quality</source>
        <translation>Angestrebte Bilder je Sekunde: mehr davon sind auf langsamen Rechnern kleiner. In Ruhe haben sie immer volle Qualität</translation>
    </message>
    <message>
        <source>pictures/s</source>
        <translation>Bilder/s</translation>
    </message>
    <message>
        <source>Background of new data</source>
        <translation>Hintergrund neuer Daten</translation>
    </message>
    <message>
        <source>Colour behind the volume when data are opened without a session</source>
        <translation>Farbe hinter dem Volumen, wenn Daten ohne Sitzung geöffnet werden</translation>
    </message>
    <message>
        <source>Unit of new openings</source>
        <translation>Einheit neuer Öffnungen</translation>
    </message>
    <message>
        <source>What the widths of the opening are in when data are opened without a session</source>
        <translation>Worin die Breiten der Öffnung gemessen werden, wenn Daten ohne Sitzung geöffnet werden</translation>
    </message>
    <message>
        <source>Hide the patient</source>
        <translation>Patient verbergen</translation>
    </message>
    <message>
        <source>No patient and no study in corner texts, and no folder that may be named after them in the recent list and in what file dialogs remember</source>
        <translation>Kein Patient und keine Studie in Ecktexten, und kein Ordner, der nach ihnen heißen kann, in der Liste zuletzt geöffneter Daten und im Gedächtnis der Dateidialoge</translation>
    </message>
    <message>
        <source>Remember recent data</source>
        <translation>Zuletzt geöffnete Daten merken</translation>
    </message>
    <message>
        <source>List the folders and files opened last in the File menu</source>
        <translation>Listet die zuletzt geöffneten Ordner und Dateien im Menü Datei</translation>
    </message>
    <message>
        <source>Keep a copy of unsaved work</source>
        <translation>Kopie ungespeicherter Arbeit behalten</translation>
    </message>
    <message>
        <source>Every minute, to be offered after a crash</source>
        <translation>Jede Minute, nach einem Absturz angeboten</translation>
    </message>
    <message>
        <source>volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Methode</translation>
    </message>
    <message>
        <source>How the view is opened to the focus</source>
        <translation>Wie sich die Ansicht zum Fokus öffnet</translation>
    </message>
    <message>
        <source>Adaptive cutaway</source>
        <translation>Adaptiver Freischnitt</translation>
    </message>
    <message>
        <source>Deformable cutting plane</source>
        <translation>Verformbare Schnittebene</translation>
    </message>
    <message>
        <source>ClearView</source>
        <translation>ClearView</translation>
    </message>
    <message>
        <source>Lens keeps</source>
        <translation>Linse behält</translation>
    </message>
    <message>
        <source>What stays within ClearView&apos;s lens of what hides the focus, beside its bends</source>
        <translation>Was in ClearViews Linse vom Verdeckenden bleibt, neben seinen Biegungen</translation>
    </message>
    <message>
        <source>Lens over</source>
        <translation>Linse über</translation>
    </message>
    <message>
        <source>What ClearView&apos;s lens lies over, as you see it</source>
        <translation>Worüber ClearViews Linse liegt, wie Sie es sehen</translation>
    </message>
    <message>
        <source>Lens</source>
        <translation>Linse</translation>
    </message>
    <message>
        <source>Radius of ClearView&apos;s lens, as a share of the volume&apos;s longest side; its authors use 18.2</source>
        <translation>Radius von ClearViews Linse als Anteil der längsten Seite des Volumens; ihre Autoren nehmen 18,2</translation>
    </message>
    <message>
        <source>Bends kept</source>
        <translation>Biegungen bleiben</translation>
    </message>
    <message>
        <source>How much of the bends of what hides the focus stays within ClearView&apos;s lens; 0 keeps none</source>
        <translation>Wie viel von den Biegungen des Verdeckenden in ClearViews Linse bleibt; 0 behält nichts</translation>
    </message>
    <message>
        <source>Rim of the lens</source>
        <translation>Rand der Linse</translation>
    </message>
    <message>
        <source>How thin the dark line around ClearView&apos;s lens is: more is thinner</source>
        <translation>Wie dünn die dunkle Linie um ClearViews Linse ist: mehr ist dünner</translation>
    </message>
    <message>
        <source>Focus</source>
        <translation>Fokus</translation>
    </message>
    <message>
        <source>The middle of the focus</source>
        <translation>Die Mitte des Fokus</translation>
    </message>
    <message>
        <source>Crosshair</source>
        <translation>Fadenkreuz</translation>
    </message>
    <message>
        <source>The crosshair: the lens follows what you point at</source>
        <translation>Das Fadenkreuz: die Linse folgt dem, worauf Sie zeigen</translation>
    </message>
    <message>
        <source>To the rim</source>
        <translation>Zum Rand hin</translation>
    </message>
    <message>
        <source>The nearer to the lens&apos;s rim, the more of what hides the focus</source>
        <translation>Je näher am Rand der Linse, desto mehr vom Verdeckenden</translation>
    </message>
    <message>
        <source>Evenly</source>
        <translation>Gleichmäßig</translation>
    </message>
    <message>
        <source>Nothing but the bends of what hides the focus</source>
        <translation>Nichts als die Biegungen des Verdeckenden</translation>
    </message>
    <message>
        <source>With depth</source>
        <translation>Mit der Tiefe</translation>
    </message>
    <message>
        <source>The more lies in front of the focus, the more of it</source>
        <translation>Je mehr vor dem Fokus liegt, desto mehr davon</translation>
    </message>
    <message>
        <source>Cone cutaway</source>
        <translation>Kegelschnitt</translation>
    </message>
    <message>
        <source>Cone&apos;s angle</source>
        <translation>Kegelwinkel</translation>
    </message>
    <message>
        <source>Angle between the axis and the wall of the cone cutaway&apos;s cones: more opens wider</source>
        <translation>Winkel zwischen Achse und Wand der Kegel: mehr öffnet weiter</translation>
    </message>
    <message>
        <source>Context-preserving</source>
        <translation>Kontexterhaltend</translation>
    </message>
    <message>
        <source>Reach</source>
        <translation>Reichweite</translation>
    </message>
    <message>
        <source>How deep the context-preserving method looks into the volume; 0 fades nothing (κt)</source>
        <translation>Wie tief die kontexterhaltende Methode ins Volumen blickt; 0 blendet nichts aus (κt)</translation>
    </message>
    <message>
        <source>Sharpness</source>
        <translation>Schärfe</translation>
    </message>
    <message>
        <source>How sudden the context-preserving method changes from faded to shown along the line of sight: more looks like a cut (κs)</source>
        <translation>Wie plötzlich die kontexterhaltende Methode entlang der Blickrichtung von ausgeblendet zu gezeigt wechselt: mehr sieht eher wie ein Schnitt aus (κs)</translation>
    </message>
    <message>
        <source>Exploded view</source>
        <translation>Explosionsansicht</translation>
    </message>
    <message>
        <source>Explosion</source>
        <translation>Explosion</translation>
    </message>
    <message>
        <source>How far the parts of an exploded view are moved apart (its degree of explosion): at 0 all are in their places</source>
        <translation>Wie weit die Teile auseinandergerückt sind (Explosionsgrad): bei 0 sind alle an ihrem Ort</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Teile</translation>
    </message>
    <message>
        <source>How many planes through the middle of the focus, or of the volume without a focus, cut it into the parts of an exploded view</source>
        <translation>Wie viele Ebenen durch die Mitte des Fokus, oder ohne Fokus des Volumens, es in die Teile einer Explosionsansicht schneiden</translation>
    </message>
    <message>
        <source>Cut along</source>
        <translation>Schnitt entlang</translation>
    </message>
    <message>
        <source>Whether the planes of an exploded view lie along the patient&apos;s axes or the view&apos;s</source>
        <translation>Ob die Ebenen entlang der Achsen des Patienten oder der Ansicht liegen</translation>
    </message>
    <message>
        <source>Two halves</source>
        <translation>Zwei Hälften</translation>
    </message>
    <message>
        <source>One plane cuts the volume into left and right</source>
        <translation>Eine Ebene schneidet das Volumen in links und rechts</translation>
    </message>
    <message>
        <source>Four quarters</source>
        <translation>Vier Viertel</translation>
    </message>
    <message>
        <source>Two planes: left and right, above and below</source>
        <translation>Zwei Ebenen: links und rechts, oben und unten</translation>
    </message>
    <message>
        <source>Eight parts</source>
        <translation>Acht Teile</translation>
    </message>
    <message>
        <source>Three planes: left and right, above and below, front and back</source>
        <translation>Drei Ebenen: links und rechts, oben und unten, vorn und hinten</translation>
    </message>
    <message>
        <source>The patient</source>
        <translation>Patient</translation>
    </message>
    <message>
        <source>Planes along the patient&apos;s axes: left and right are the patient&apos;s</source>
        <translation>Ebenen entlang der Achsen des Patienten: links und rechts sind die des Patienten</translation>
    </message>
    <message>
        <source>The view</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Planes along the picture&apos;s axes, which turn with the camera</source>
        <translation>Ebenen entlang der Achsen des Bilds, die mit der Kamera drehen</translation>
    </message>
    <message>
        <source>Focal region</source>
        <translation>Fokusregion</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Region</translation>
    </message>
    <message>
        <source>Shape of the focal region, around the focus, or around the middle of the volume without a focus</source>
        <translation>Form der Fokusregion, um den Fokus oder ohne Fokus um die Mitte des Volumens</translation>
    </message>
    <message>
        <source>Size of region</source>
        <translation>Größe der Region</translation>
    </message>
    <message>
        <source>Radius of the focal region&apos;s sphere, half the side of its box, or its distance from the focus</source>
        <translation>Radius der Kugel, halbe Seite des Quaders, oder Abstand vom Fokus</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Fall-off</source>
        <translation>Abfall</translation>
    </message>
    <message>
        <source>How far outside of the focal region edges are half as strong as at its border: more shows more of what is around it</source>
        <translation>In welchem Abstand von der Fokusregion Kanten halb so stark sind wie an ihrem Rand: mehr zeigt mehr von der Umgebung</translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>A ball around the middle of the focus</source>
        <translation>Eine Kugel um die Mitte des Fokus</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Quader</translation>
    </message>
    <message>
        <source>A cube along the patient&apos;s axes, around the middle of the focus</source>
        <translation>Ein Würfel entlang der Achsen des Patienten um die Mitte des Fokus</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Strecke</translation>
    </message>
    <message>
        <source>Everything that lies near the focus, whatever its shape</source>
        <translation>Alles, was nahe am Fokus liegt, welche Form er auch hat</translation>
    </message>
    <message>
        <source>Importance-driven</source>
        <translation>Nach Wichtigkeit</translation>
    </message>
    <message>
        <source>What hides the focus</source>
        <translation>Was den Fokus verdeckt</translation>
    </message>
    <message>
        <source>What the importance-driven method does with what hides the focus</source>
        <translation>Was die Methode nach Wichtigkeit mit dem tut, was den Fokus verdeckt</translation>
    </message>
    <message>
        <source>Widening</source>
        <translation>Aufweitung</translation>
    </message>
    <message>
        <source>Angle at which the importance-driven opening widens from the focus&apos;s outline towards the eye</source>
        <translation>Winkel, mit dem sich die Öffnung vom Umriss des Fokus zum Auge hin weitet</translation>
    </message>
    <message>
        <source>Opacity left</source>
        <translation>Restdeckkraft</translation>
    </message>
    <message>
        <source>Factor of the opacity of what hides the focus, where the importance-driven method keeps it faint; 0 removes it</source>
        <translation>Faktor der Deckkraft dessen, was den Fokus verdeckt, wo die Methode es schwach zeigt; 0 entfernt es</translation>
    </message>
    <message>
        <source>Faint how</source>
        <translation>Wie schwach</translation>
    </message>
    <message>
        <source>How what hides the focus is made faint</source>
        <translation>Wie das Verdeckende abgeschwächt wird</translation>
    </message>
    <message>
        <source>Removed</source>
        <translation>Entfernt</translation>
    </message>
    <message>
        <source>What hides the focus is removed, in a cone that widens from the focus&apos;s outline towards you (maximum importance projection)</source>
        <translation>Das Verdeckende wird entfernt, in einem Kegel, der sich vom Umriss des Fokus zu Ihnen weitet (Maximum Importance Projection)</translation>
    </message>
    <message>
        <source>Faint</source>
        <translation>Schwach</translation>
    </message>
    <message>
        <source>What hides the focus stays, but faint (average importance compositing)</source>
        <translation>Das Verdeckende bleibt, aber schwach (Average Importance Compositing)</translation>
    </message>
    <message>
        <source>See-through</source>
        <translation>Durchscheinend</translation>
    </message>
    <message>
        <source>Less opaque, in its own colours</source>
        <translation>Weniger deckend, in den eigenen Farben</translation>
    </message>
    <message>
        <source>Grey</source>
        <translation>Grau</translation>
    </message>
    <message>
        <source>Less opaque, and grey, so that the colours are the focus&apos;s alone</source>
        <translation>Weniger deckend und grau, sodass nur der Fokus Farben hat</translation>
    </message>
    <message>
        <source>Dotted</source>
        <translation>Gepunktet</translation>
    </message>
    <message>
        <source>As it is on a few pixels in an even pattern, and left out on the others</source>
        <translation>Unverändert auf wenigen Pixeln in gleichmäßigem Muster, auf den anderen weggelassen</translation>
    </message>
    <message>
        <source>Maximum intensity (MIP)</source>
        <translation>Maximale Intensität (MIP)</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Dicke</translation>
    </message>
    <message>
        <source>How thick a layer the maximum intensity projection shows of the greatest value: more is more opaque</source>
        <translation>Wie dick eine Schicht des größten Werts die Maximumintensitätsprojektion zeigt: mehr deckt mehr</translation>
    </message>
    <message>
        <source>Peeling</source>
        <translation>Abschälen</translation>
    </message>
    <message>
        <source>Peeled</source>
        <translation>Abgeschält</translation>
    </message>
    <message>
        <source>How far the layer in front of the focus is peeled away: at 0 it lies in its place, at 1 none of it lies in front of the focus</source>
        <translation>Wie weit die Schicht vor dem Fokus abgeschält ist: bei 0 liegt sie an ihrem Ort, bei 1 liegt nichts davon vor dem Fokus</translation>
    </message>
    <message>
        <source>Peel off</source>
        <translation>Abschälen von</translation>
    </message>
    <message>
        <source>Which side of the patient the layer is peeled off</source>
        <translation>Von welcher Seite des Patienten die Schicht abgeschält wird</translation>
    </message>
    <message>
        <source>Cut turned by</source>
        <translation>Schnitt gedreht um</translation>
    </message>
    <message>
        <source>Turns the cut through the layer: at 0 it runs from head to foot, or from front to back where the layer is peeled off above or below</source>
        <translation>Dreht den Schnitt durch die Schicht: bei 0 läuft er von Kopf zu Fuß, oder von vorn nach hinten, wenn oben oder unten abgeschält wird</translation>
    </message>
    <message>
        <source>Layer down to</source>
        <translation>Schicht bis</translation>
    </message>
    <message>
        <source>How deep the layer reaches: at 0 it ends just in front of the focus, at 1 just behind it</source>
        <translation>Wie tief die Schicht reicht: bei 0 endet sie knapp vor dem Fokus, bei 1 knapp dahinter</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>Rolle</translation>
    </message>
    <message>
        <source>Radius of the hollow in the roll: less rolls the layer up more tightly</source>
        <translation>Radius des Hohlraums der Rolle: weniger rollt die Schicht enger auf</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Spielraum</translation>
    </message>
    <message>
        <source>How far the opened window reaches beyond the focus on all its sides</source>
        <translation>Wie weit das geöffnete Fenster auf allen Seiten über den Fokus hinausreicht</translation>
    </message>
    <message>
        <source>The front</source>
        <translation>Vorn</translation>
    </message>
    <message>
        <source>The patient&apos;s anterior side</source>
        <translation>Die anteriore Seite des Patienten</translation>
    </message>
    <message>
        <source>The back</source>
        <translation>Hinten</translation>
    </message>
    <message>
        <source>The patient&apos;s posterior side</source>
        <translation>Die posteriore Seite des Patienten</translation>
    </message>
    <message>
        <source>The left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>The patient&apos;s left side</source>
        <translation>Die linke Seite des Patienten</translation>
    </message>
    <message>
        <source>The right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>The patient&apos;s right side</source>
        <translation>Die rechte Seite des Patienten</translation>
    </message>
    <message>
        <source>Above</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>The patient&apos;s superior side</source>
        <translation>Die superiore Seite des Patienten</translation>
    </message>
    <message>
        <source>Below</source>
        <translation>Unten</translation>
    </message>
    <message>
        <source>The patient&apos;s inferior side</source>
        <translation>Die inferiore Seite des Patienten</translation>
    </message>
    <message>
        <source>Sculpting</source>
        <translation>Schnitzen</translation>
    </message>
    <message>
        <source>Ghosted selection</source>
        <translation>Geisterbild der Auswahl</translation>
    </message>
    <message>
        <source>Ghosting</source>
        <translation>Geistereffekt</translation>
    </message>
    <message>
        <source>How much of what is flat in front of the selection gives way; 0 fades nothing</source>
        <translation>Wie viel vom Flachen vor der Auswahl zurücktritt; 0 blendet nichts aus</translation>
    </message>
    <message>
        <source>Edges from</source>
        <translation>Kanten ab</translation>
    </message>
    <message>
        <source>Gradient of which half stays in front of the selection, as a share of the steepest that the volume can have: less keeps fainter edges</source>
        <translation>Gradient, von dem die Hälfte vor der Auswahl bleibt, als Anteil des steilsten, den das Volumen haben kann: weniger behält schwächere Kanten</translation>
    </message>
    <message>
        <source>Outlines</source>
        <translation>Umrisse</translation>
    </message>
    <message>
        <source>How much edges that face you give way, too, so that outlines stay in front of the selection</source>
        <translation>Wie viel Kanten, die Ihnen zugewandt sind, ebenfalls zurücktreten, sodass Umrisse vor der Auswahl bleiben</translation>
    </message>
    <message>
        <source>Walls of slices</source>
        <translation>Schichtwände</translation>
    </message>
    <message>
        <source>Walls</source>
        <translation>Wände</translation>
    </message>
    <message>
        <source>Where the walls of slices stand</source>
        <translation>Wo die Schichtwände stehen</translation>
    </message>
    <message>
        <source>Axial</source>
        <translation>Axial</translation>
    </message>
    <message>
        <source>Whether the axial slice at the crosshair is a wall</source>
        <translation>Ob die axiale Schicht am Fadenkreuz eine Wand ist</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagittal</translation>
    </message>
    <message>
        <source>Whether the sagittal slice at the crosshair is a wall</source>
        <translation>Ob die sagittale Schicht am Fadenkreuz eine Wand ist</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>Koronal</translation>
    </message>
    <message>
        <source>Whether the coronal slice at the crosshair is a wall</source>
        <translation>Ob die koronale Schicht am Fadenkreuz eine Wand ist</translation>
    </message>
    <message>
        <source>Whether the labels&apos; outlines are drawn on the walls</source>
        <translation>Ob die Umrisse der Labels auf den Wänden gezeichnet werden</translation>
    </message>
    <message>
        <source>Around the volume</source>
        <translation>Um das Volumen</translation>
    </message>
    <message>
        <source>Behind the volume, like the walls of a room</source>
        <translation>Hinter dem Volumen, wie die Wände eines Raums</translation>
    </message>
    <message>
        <source>Inside the opening</source>
        <translation>In der Öffnung</translation>
    </message>
    <message>
        <source>Where the slices lie, in the space that the opening removed; before the focus there is none</source>
        <translation>Wo die Schichten liegen, in dem Raum, den die Öffnung freilegt; vor dem Fokus ist keine</translation>
    </message>
    <message>
        <source>pixels</source>
        <translation>Pixel</translation>
    </message>
    <message>
        <source>millimetres at the focus</source>
        <translation>Millimeter am Fokus</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>A ball, where the mouse goes</source>
        <translation>Eine Kugel, wo die Maus geht</translation>
    </message>
    <message>
        <source>A box that faces you, where the mouse goes</source>
        <translation>Ein Quader, der Ihnen zugewandt ist, wo die Maus geht</translation>
    </message>
    <message>
        <source>Saw</source>
        <translation>Säge</translation>
    </message>
    <message>
        <source>A blade along the stroke, away from you; a stroke that comes back to its start takes out what it encloses</source>
        <translation>Ein Sägeblatt entlang des Strichs, von Ihnen weg; ein Strich, der zu seinem Anfang zurückkehrt, nimmt heraus, was er umschließt</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>A plane through the stroke that removes what lies to the right of it, and that you bend by dragging</source>
        <translation>Eine Ebene durch den Strich, die entfernt, was rechts davon liegt, und die Sie durch Ziehen biegen</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Brings back what the opening removed</source>
        <translation>Bringt zurück, was die Öffnung entfernt hat</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Opens further, away from the eye</source>
        <translation>Öffnet weiter, vom Auge weg</translation>
    </message>
    <message>
        <source>Fade</source>
        <translation>Abschwächen</translation>
    </message>
    <message>
        <source>Shows less of the context&apos;s edges over the focus</source>
        <translation>Zeigt über dem Fokus weniger von den Kanten des Kontexts</translation>
    </message>
    <message>
        <source>Strengthen</source>
        <translation>Verstärken</translation>
    </message>
    <message>
        <source>Shows more of the context&apos;s edges over the focus</source>
        <translation>Zeigt über dem Fokus mehr von den Kanten des Kontexts</translation>
    </message>
    <message>
        <source>Context</source>
        <translation>Kontext</translation>
    </message>
    <message>
        <source>Cut away where it hides the focus</source>
        <translation>Weggeschnitten, wo es den Fokus verdeckt</translation>
    </message>
    <message>
        <source>Hidden</source>
        <translation>Verborgen</translation>
    </message>
    <message>
        <source>Left out of 3-D pictures; slices show its voxels</source>
        <translation>Fehlt in 3-D-Bildern; Schichten zeigen die Voxel</translation>
    </message>
    <message>
        <source>Protected</source>
        <translation>Geschützt</translation>
    </message>
    <message>
        <source>Never cut away, even where it hides the focus</source>
        <translation>Nie weggeschnitten, auch wo es den Fokus verdeckt</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>What is connected to the click by values near its own</source>
        <translation>Was mit der angeklickten Stelle durch ähnliche Werte verbunden ist</translation>
    </message>
    <message>
        <source>Tissues</source>
        <translation>Gewebe</translation>
    </message>
    <message>
        <source>What belongs to the clicked tissue more than to any other of the volume</source>
        <translation>Was eher zum angeklickten Gewebe gehört als zu einem anderen des Volumens</translation>
    </message>
    <message>
        <source>Straight</source>
        <translation>Gerade</translation>
    </message>
    <message>
        <source>Straight lines between voxels: coarse scans show terraces</source>
        <translation>Gerade Linien zwischen Voxeln: grobe Aufnahmen zeigen Terrassen</translation>
    </message>
    <message>
        <source>Curved</source>
        <translation>Gekrümmt</translation>
    </message>
    <message>
        <source>Smooth curves through every voxel, its noise as well: takes more memory and time</source>
        <translation>Glatte Kurven durch jeden Voxel, auch durch sein Rauschen: braucht mehr Speicher und Zeit</translation>
    </message>
    <message>
        <source>Smoothed</source>
        <translation>Geglättet</translation>
    </message>
    <message>
        <source>Smooth curves near the voxels: fewer terraces and less noise, but softer detail</source>
        <translation>Glatte Kurven nahe den Voxeln: weniger Terrassen und Rauschen, aber weichere Details</translation>
    </message>
    <message>
        <source>Smoothed more</source>
        <translation>Stärker geglättet</translation>
    </message>
    <message>
        <source>Smooth curves near means over five voxels: no terraces in coarse scans, but fine detail is lost</source>
        <translation>Glatte Kurven nahe Mitteln über fünf Voxel: keine Terrassen in groben Aufnahmen, aber feine Details gehen verloren</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Smoothed where voxels are coarse and not too many, else straight</source>
        <translation>Geglättet, wo Voxel grob und nicht zu viele sind, sonst gerade</translation>
    </message>
    <message>
        <source>One colour</source>
        <translation>Eine Farbe</translation>
    </message>
    <message>
        <source>The background&apos;s colour everywhere</source>
        <translation>Überall die Farbe des Hintergrunds</translation>
    </message>
    <message>
        <source>Gradient</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>From the background&apos;s colour at the bottom to another at the top</source>
        <translation>Von der Farbe des Hintergrunds unten zu einer anderen oben</translation>
    </message>
    <message>
        <source>Exact</source>
        <translation>Genau</translation>
    </message>
    <message>
        <source>As the labels have it, with the steps of their voxels</source>
        <translation>Wie die Labels sie haben, mit den Stufen ihrer Voxel</translation>
    </message>
    <message>
        <source>Lightly smoothed</source>
        <translation>Leicht geglättet</translation>
    </message>
    <message>
        <source>Without the steps of single voxels</source>
        <translation>Ohne die Stufen einzelner Voxel</translation>
    </message>
    <message>
        <source>Strongly smoothed</source>
        <translation>Stark geglättet</translation>
    </message>
    <message>
        <source>Without terraces of several voxels</source>
        <translation>Ohne Terrassen mehrerer Voxel</translation>
    </message>
    <message>
        <source>One ray a pixel</source>
        <translation>Ein Strahl je Pixel</translation>
    </message>
    <message>
        <source>Edges show the steps of the pixels</source>
        <translation>Kanten zeigen die Stufen der Pixel</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Glatt</translation>
    </message>
    <message>
        <source>Several rays for each pixel that an edge runs through</source>
        <translation>Mehrere Strahlen für jeden Pixel, durch den eine Kante läuft</translation>
    </message>
    <message>
        <source>perspective</source>
        <translation>perspektivisch</translation>
    </message>
    <message>
        <source>orthographic</source>
        <translation>orthografisch</translation>
    </message>
    <message>
        <source>draft</source>
        <translation>Entwurf</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>normal</translation>
    </message>
    <message>
        <source>high</source>
        <translation>hoch</translation>
    </message>
    <message>
        <source>Open the context around the focus</source>
        <translation>Kontext um den Fokus öffnen</translation>
    </message>
    <message>
        <source>Whether the context is cut away around the focus</source>
        <translation>Ob der Kontext um den Fokus weggeschnitten wird</translation>
    </message>
    <message>
        <source>Opening</source>
        <translation>Öffnung</translation>
    </message>
    <message>
        <source>How far the opening reaches beyond the focus (w_open)</source>
        <translation>Wie weit die Öffnung über den Fokus hinausreicht (w_open)</translation>
    </message>
    <message>
        <source>Border</source>
        <translation>Rand</translation>
    </message>
    <message>
        <source>Width of the line around the opening (w_border)</source>
        <translation>Breite der Linie um die Öffnung (w_border)</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Unit of both widths: pixels of the screen, or mm at the depth of the focus, which keep the opening still while zooming</source>
        <translation>Einheit beider Breiten: Pixel des Bildschirms, oder mm in der Tiefe des Fokus, bei denen die Öffnung beim Vergrößern bleibt</translation>
    </message>
    <message>
        <source>Border colour</source>
        <translation>Randfarbe</translation>
    </message>
    <message>
        <source>Colour of the line around the opening</source>
        <translation>Farbe der Linie um die Öffnung</translation>
    </message>
    <message>
        <source>Axis offset</source>
        <translation>Achsneigung</translation>
    </message>
    <message>
        <source>Angle between the opening&apos;s axis and the line of sight, so that its depth shows</source>
        <translation>Winkel zwischen der Achse der Öffnung und der Blickrichtung, damit ihre Tiefe zu sehen ist</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>To which side of the picture the opening&apos;s axis leans: 0 is the right, 90 the top</source>
        <translation>Zu welcher Seite des Bilds die Achse der Öffnung sich neigt: 0 ist rechts, 90 oben</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Stärke</translation>
    </message>
    <message>
        <source>How strongly the edges of the removed context are drawn over the focus; 0 draws none</source>
        <translation>Wie stark die Kanten des entfernten Kontexts über dem Fokus gezeichnet werden; 0 zeichnet keine</translation>
    </message>
    <message>
        <source>Curvature</source>
        <translation>Krümmung</translation>
    </message>
    <message>
        <source>How much bends of the context&apos;s surface count as edges: eyes, nose, ears</source>
        <translation>Wie sehr Biegungen der Oberfläche des Kontexts als Kanten zählen: Augen, Nase, Ohren</translation>
    </message>
    <message>
        <source>Silhouette</source>
        <translation>Silhouette</translation>
    </message>
    <message>
        <source>How much the context&apos;s outlines, where its surface is seen edge-on, count as edges</source>
        <translation>Wie sehr die Umrisse des Kontexts, wo seine Oberfläche von der Kante gesehen wird, als Kanten zählen</translation>
    </message>
    <message>
        <source>Illumination</source>
        <translation>Beleuchtung</translation>
    </message>
    <message>
        <source>How much the light on the context&apos;s surface shades its edges; 0 draws them flat</source>
        <translation>Wie sehr das Licht auf der Oberfläche des Kontexts seine Kanten schattiert; 0 zeichnet sie flach</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Eigenfarbe</translation>
    </message>
    <message>
        <source>How much the edges take the context&apos;s own colour</source>
        <translation>Wie sehr die Kanten die eigene Farbe des Kontexts annehmen</translation>
    </message>
    <message>
        <source>Saturation</source>
        <translation>Sättigung</translation>
    </message>
    <message>
        <source>How saturated the context&apos;s own colour is in its edges</source>
        <translation>Wie gesättigt die eigene Farbe des Kontexts in seinen Kanten ist</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Anteil</translation>
    </message>
    <message>
        <source>How much of the focus the edges may cover at most: the strongest stay; 1 keeps all</source>
        <translation>Wie viel vom Fokus die Kanten höchstens bedecken: die stärksten bleiben; 1 behält alle</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Colour of the context&apos;s edges</source>
        <translation>Farbe der Kanten des Kontexts</translation>
    </message>
    <message>
        <source>Shading</source>
        <translation>Schattierung</translation>
    </message>
    <message>
        <source>Whether surfaces are lit by the gradient of the values</source>
        <translation>Ob Oberflächen nach dem Gradienten der Werte beleuchtet werden</translation>
    </message>
    <message>
        <source>Ambient</source>
        <translation>Umgebung</translation>
    </message>
    <message>
        <source>Light from all sides</source>
        <translation>Licht von allen Seiten</translation>
    </message>
    <message>
        <source>Diffuse</source>
        <translation>Diffus</translation>
    </message>
    <message>
        <source>Light that a matt surface scatters</source>
        <translation>Licht, das eine matte Oberfläche streut</translation>
    </message>
    <message>
        <source>Specular</source>
        <translation>Spiegelnd</translation>
    </message>
    <message>
        <source>Strength of the highlights</source>
        <translation>Stärke der Glanzlichter</translation>
    </message>
    <message>
        <source>Shininess</source>
        <translation>Glanz</translation>
    </message>
    <message>
        <source>Exponent of the highlights: a larger one makes them smaller and sharper</source>
        <translation>Exponent der Glanzlichter: ein größerer macht sie kleiner und schärfer</translation>
    </message>
    <message>
        <source>Light azimuth</source>
        <translation>Lichtazimut</translation>
    </message>
    <message>
        <source>Where the light comes from: 0 is behind the viewer, 90 the right of the picture</source>
        <translation>Woher das Licht kommt: 0 ist hinter dem Betrachter, 90 rechts vom Bild</translation>
    </message>
    <message>
        <source>Light elevation</source>
        <translation>Lichthöhe</translation>
    </message>
    <message>
        <source>How high the light stands: 90 is the top of the picture, -90 the bottom</source>
        <translation>Wie hoch das Licht steht: 90 ist oben im Bild, -90 unten</translation>
    </message>
    <message>
        <source>Occlusion</source>
        <translation>Verdeckung</translation>
    </message>
    <message>
        <source>How dark hollows are, which what is around them hides from the light from all sides; 0 leaves them as bright as the rest and costs nothing</source>
        <translation>Wie dunkel Höhlungen sind, denen die Umgebung das Licht von allen Seiten nimmt; 0 lässt sie so hell wie den Rest und kostet nichts</translation>
    </message>
    <message>
        <source>Soft shadow</source>
        <translation>Weicher Schatten</translation>
    </message>
    <message>
        <source>How dark the shadows are that the volume, as it is cut open, casts on itself; 0 casts none and costs nothing</source>
        <translation>Wie dunkel die Schatten sind, die das aufgeschnittene Volumen auf sich selbst wirft; 0 wirft keine und kostet nichts</translation>
    </message>
    <message>
        <source>Colour of a focus of values; labels have colours of their own</source>
        <translation>Farbe eines Fokus aus Werten; Labels haben eigene Farben</translation>
    </message>
    <message>
        <source>Extinction</source>
        <translation>Extinktion</translation>
    </message>
    <message>
        <source>Extinction coefficient of the focus</source>
        <translation>Extinktionskoeffizient des Fokus</translation>
    </message>
    <message>
        <source>1/mm</source>
        <translation>1/mm</translation>
    </message>
    <message>
        <source>Smallest island</source>
        <translation>Kleinste Insel</translation>
    </message>
    <message>
        <source>Volume below which an island of a focus of values is left out</source>
        <translation>Volumen, unter dem eine Insel eines Fokus aus Werten entfällt</translation>
    </message>
    <message>
        <source>mm³</source>
        <translation>mm³</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Verschiebung</translation>
    </message>
    <message>
        <source>Moves the whole transfer function along the values</source>
        <translation>Verschiebt die ganze Transferfunktion entlang der Werte</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Hintergrund</translation>
    </message>
    <message>
        <source>Colour behind the volume; of a gradient, at the bottom</source>
        <translation>Farbe hinter dem Volumen; bei einem Verlauf unten</translation>
    </message>
    <message>
        <source>Backdrop</source>
        <translation>Hintergrundart</translation>
    </message>
    <message>
        <source>Whether one colour is behind the volume, or a gradient of two</source>
        <translation>Ob hinter dem Volumen eine Farbe oder ein Verlauf aus zweien ist</translation>
    </message>
    <message>
        <source>Top of the gradient</source>
        <translation>Oben im Verlauf</translation>
    </message>
    <message>
        <source>Colour of a gradient behind the volume at the top</source>
        <translation>Farbe eines Verlaufs hinter dem Volumen oben</translation>
    </message>
    <message>
        <source>Hide the table</source>
        <translation>Tisch ausblenden</translation>
    </message>
    <message>
        <source>Whether 3-D pictures of a CT leave out the scanner&apos;s table, head rest and cushions</source>
        <translation>Ob 3-D-Bilder eines CT Tisch, Kopfstütze und Polster des Scanners weglassen</translation>
    </message>
    <message>
        <source>Between voxels</source>
        <translation>Zwischen Voxeln</translation>
    </message>
    <message>
        <source>How 3-D pictures fill in the values between the voxels</source>
        <translation>Wie 3-D-Bilder die Werte zwischen den Voxeln ergänzen</translation>
    </message>
    <message>
        <source>Label surfaces</source>
        <translation>Labeloberflächen</translation>
    </message>
    <message>
        <source>How far 3-D pictures smooth the surface of labels in focus: it stays within the voxels that it passes through, and keeps its volume</source>
        <translation>Wie weit 3-D-Bilder die Oberfläche von Labels im Fokus glätten: sie bleibt in den Voxeln, durch die sie läuft, und behält ihr Volumen</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Kanten</translation>
    </message>
    <message>
        <source>Whether 3-D pictures at rest smooth outlines and the rims of what is cut</source>
        <translation>Ob ruhende 3-D-Bilder Umrisse und Schnittränder glätten</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Modus</translation>
    </message>
    <message>
        <source>What the stroke does</source>
        <translation>Was der Strich tut</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Radius of the brush</source>
        <translation>Radius des Pinsels</translation>
    </message>
    <message>
        <source>Softness</source>
        <translation>Weichheit</translation>
    </message>
    <message>
        <source>Share of the radius over which the effect fades out</source>
        <translation>Anteil des Radius, über den die Wirkung ausläuft</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>How far along the ray Restore and Open move its start at most</source>
        <translation>Wie weit Wiederherstellen und Öffnen den Anfang des Strahls höchstens verschieben</translation>
    </message>
    <message>
        <source>Amount</source>
        <translation>Menge</translation>
    </message>
    <message>
        <source>How much of the context&apos;s edges Fade takes or Strengthen adds</source>
        <translation>Wie viel Abschwächen von den Kanten des Kontexts nimmt oder Verstärken hinzufügt</translation>
    </message>
    <message>
        <source>To the surface</source>
        <translation>Bis zur Oberfläche</translation>
    </message>
    <message>
        <source>Whether Restore reaches to the context&apos;s first surface, however deep that lies</source>
        <translation>Ob Wiederherstellen bis zur ersten Oberfläche des Kontexts reicht, wie tief sie auch liegt</translation>
    </message>
    <message>
        <source>May cover the focus</source>
        <translation>Darf den Fokus verdecken</translation>
    </message>
    <message>
        <source>Whether restored context may hide the focus</source>
        <translation>Ob wiederhergestellter Kontext den Fokus verdecken darf</translation>
    </message>
    <message>
        <source>Whether the stroke is kept without effect</source>
        <translation>Ob der Strich ohne Wirkung aufbewahrt wird</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>View in which it shows: 0 for C1, 1 for C2, -1 for both</source>
        <translation>Ansicht, in der er gilt: 0 für C1, 1 für C2, -1 für beide</translation>
    </message>
    <message>
        <source>Edges and border</source>
        <translation>Kanten und Rand</translation>
    </message>
    <message>
        <source>Cut alone</source>
        <translation>Nur Schnitt</translation>
    </message>
    <message>
        <source>Context&apos;s edges</source>
        <translation>Kanten des Kontexts</translation>
    </message>
    <message>
        <source>the point lies outside of the volume</source>
        <translation>der Punkt liegt außerhalb des Volumens</translation>
    </message>
    <message>
        <source>the point lies in air, where there is no structure</source>
        <translation>der Punkt liegt in Luft, wo keine Struktur ist</translation>
    </message>
    <message>
        <source>no region can be grown from the point</source>
        <translation>von dem Punkt lässt sich keine Region wachsen</translation>
    </message>
    <message>
        <source>Head</source>
        <translation>Kopf</translation>
    </message>
    <message>
        <source>Torso</source>
        <translation>Torso</translation>
    </message>
    <message>
        <source>CT angio</source>
        <translation>CT Angio</translation>
    </message>
    <message>
        <source>CT bone</source>
        <translation>CT Knochen</translation>
    </message>
    <message>
        <source>CT lung</source>
        <translation>CT Lunge</translation>
    </message>
    <message>
        <source>CT plain</source>
        <translation>CT schlicht</translation>
    </message>
    <message>
        <source>CT skin</source>
        <translation>CT Haut</translation>
    </message>
    <message>
        <source>CT soft tissue</source>
        <translation>CT Weichteile</translation>
    </message>
    <message>
        <source>MR angio</source>
        <translation>MR Angio</translation>
    </message>
    <message>
        <source>MR bright</source>
        <translation>MR hell</translation>
    </message>
    <message>
        <source>MR T1</source>
        <translation>MR T1</translation>
    </message>
    <message>
        <source>MR T2</source>
        <translation>MR T2</translation>
    </message>
    <message>
        <source>MR</source>
        <translation>MR</translation>
    </message>
    <message>
        <source>PET</source>
        <translation>PET</translation>
    </message>
    <message>
        <source>Ultrasound</source>
        <translation>Ultraschall</translation>
    </message>
    <message>
        <source>making the phantom</source>
        <translation>Phantom wird erzeugt</translation>
    </message>
    <message>
        <source>unpacking</source>
        <translation>Entpacken</translation>
    </message>
    <message>
        <source>comparing contents</source>
        <translation>Inhalte werden verglichen</translation>
    </message>
    <message>
        <source>the only one whose geometry is plausible</source>
        <translation>die einzige mit plausibler Geometrie</translation>
    </message>
    <message>
        <source>the only one that is no overview, capture or reformat</source>
        <translation>die einzige, die weder Übersicht noch Bildschirmfoto noch Reformatierung ist</translation>
    </message>
    <message>
        <source>the only %1</source>
        <translation>die einzige ihrer Art (%1)</translation>
    </message>
    <message>
        <source>the thinnest %1, %2</source>
        <translation>die dünnste ihrer Art (%1), %2</translation>
    </message>
    <message>
        <source>of the thinnest ones, %1, the one of most voxels</source>
        <translation>von den dünnsten, %1, die mit den meisten Voxeln</translation>
    </message>
    <message>
        <source>the %1 of most voxels</source>
        <translation>die mit den meisten Voxeln (%1)</translation>
    </message>
    <message>
        <source>of equal ones the first by its number, %1</source>
        <translation>von gleichen die erste nach ihrer Nummer, %1</translation>
    </message>
    <message>
        <source>stack of slices</source>
        <translation>Schichtstapel</translation>
    </message>
    <message>
        <source>image</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>reading headers</source>
        <translation>Header werden gelesen</translation>
    </message>
    <message>
        <source>reading slices</source>
        <translation>Schichten werden gelesen</translation>
    </message>
    <message>
        <source>filling contours</source>
        <translation>Konturen werden gefüllt</translation>
    </message>
    <message>
        <source>reading segments</source>
        <translation>Segmente werden gelesen</translation>
    </message>
    <message>
        <source>writing segments</source>
        <translation>Segmente werden geschrieben</translation>
    </message>
    <message>
        <source>reading voxels</source>
        <translation>Voxel werden gelesen</translation>
    </message>
    <message>
        <source>growing the region</source>
        <translation>Region wächst</translation>
    </message>
    <message>
        <source>looking for moved data</source>
        <translation>Verschobene Daten werden gesucht</translation>
    </message>
    <message>
        <source>finding the focus</source>
        <translation>Fokus wird gesucht</translation>
    </message>
    <message>
        <source>extracting the surface</source>
        <translation>Oberfläche wird extrahiert</translation>
    </message>
    <message>
        <source>smoothing the surface</source>
        <translation>Oberfläche wird geglättet</translation>
    </message>
    <message>
        <source>Editing the label</source>
        <translation>Label wird bearbeitet</translation>
    </message>
    <message>
        <source>acquired volume</source>
        <translation>aufgenommenes Volumen</translation>
    </message>
    <message>
        <source>acquired stack of slices</source>
        <translation>aufgenommener Schichtstapel</translation>
    </message>
    <message>
        <source>acquired image</source>
        <translation>aufgenommenes Bild</translation>
    </message>
    <message>
        <source>volume that is no overview, capture or reformat</source>
        <translation>Volumen, das weder Übersicht noch Bildschirmfoto noch Reformatierung ist</translation>
    </message>
    <message>
        <source>stack of slices that is no overview, capture or reformat</source>
        <translation>Schichtstapel, der weder Übersicht noch Bildschirmfoto noch Reformatierung ist</translation>
    </message>
    <message>
        <source>image that is no overview, capture or reformat</source>
        <translation>Bild, das weder Übersicht noch Bildschirmfoto noch Reformatierung ist</translation>
    </message>
    <message>
        <source>An opening around the focus that rises to the surface over a width that you choose: the method of this program</source>
        <translation>Eine Öffnung um den Fokus, die über eine wählbare Breite zur Oberfläche ansteigt: die Methode dieses Programms</translation>
    </message>
    <message>
        <source>Nothing opens by itself: a plane that you lay through a stroke and bend by dragging removes one side of it (Konrad-Verse, Preim and Littmann 2004)</source>
        <translation>Nichts öffnet sich von selbst: eine Ebene, die Sie durch einen Strich legen und durch Ziehen biegen, entfernt eine Seite (Konrad-Verse, Preim und Littmann 2004)</translation>
    </message>
    <message>
        <source>A lens over the focus through which it shows, while what hides it fades towards the lens&apos;s middle and stays where it bends (Krüger, Schneider and Westermann 2006)</source>
        <translation>Eine Linse über dem Fokus, durch die er zu sehen ist, während das Verdeckende zur Linsenmitte hin verblasst und bleibt, wo es sich biegt (Krüger, Schneider und Westermann 2006)</translation>
    </message>
    <message>
        <source>A funnel around everything in focus, which widens towards you at one angle: the deeper the focus lies, the wider the opening (Burns and Finkelstein 2008)</source>
        <translation>Ein Trichter um alles im Fokus, der sich in einem Winkel zu Ihnen weitet: je tiefer der Fokus, desto weiter die Öffnung (Burns und Finkelstein 2008)</translation>
    </message>
    <message>
        <source>Nothing is cut away: what is flat, brightly lit and near to you fades, while edges stay, so that the inside shows; what is in focus stays as it is (Bruckner, Grimm, Kanitsar and Gröller 2006)</source>
        <translation>Nichts wird weggeschnitten: Flaches, hell Beleuchtetes und Nahes verblasst, Kanten bleiben, sodass das Innere zu sehen ist; was im Fokus ist, bleibt unverändert (Bruckner, Grimm, Kanitsar und Gröller 2006)</translation>
    </message>
    <message>
        <source>What is around the focus is cut into parts, which move apart and out of your line of sight to it; what is in focus stays in its place (Bruckner and Gröller 2006)</source>
        <translation>Die Umgebung des Fokus wird in Teile geschnitten, die auseinander und aus der Blickrichtung rücken; was im Fokus ist, bleibt an seinem Ort (Bruckner und Gröller 2006)</translation>
    </message>
    <message>
        <source>A region around the focus shows as it is; around it only the edges of what is there stay, the fainter the farther away; what is in focus stays as it is (Zhou, Hinz and Tönnies 2002)</source>
        <translation>Eine Region um den Fokus zeigt sich unverändert; darum herum bleiben nur Kanten, je ferner desto schwächer; was im Fokus ist, bleibt unverändert (Zhou, Hinz und Tönnies 2002)</translation>
    </message>
    <message>
        <source>What hides the focus gives way to it because the focus is more important: it is removed, or stays faint (Viola, Kanitsar and Gröller 2004)</source>
        <translation>Was den Fokus verdeckt, weicht ihm, weil er wichtiger ist: es wird entfernt oder bleibt schwach (Viola, Kanitsar und Gröller 2004)</translation>
    </message>
    <message>
        <source>The body shows by the greatest value on each line of sight, as in a maximum intensity projection, and the focus stands in it; what lies before the opening does not count (Wallis, Miller, Lerner and Kleerup 1989)</source>
        <translation>Der Körper zeigt sich durch den größten Wert jeder Blicklinie, wie in einer Maximumintensitätsprojektion, und der Fokus steht darin; was vor der Öffnung liegt, zählt nicht (Wallis, Miller, Lerner und Kleerup 1989)</translation>
    </message>
    <message>
        <source>A layer in front of the focus is cut in two, and its halves are rolled aside like a peel; what is in focus stays in its place (McGuffin et al. 2003; Correa et al. 2006)</source>
        <translation>Eine Schicht vor dem Fokus wird entzweigeschnitten und wie eine Schale zur Seite gerollt; was im Fokus ist, bleibt an seinem Ort (McGuffin et al. 2003; Correa et al. 2006)</translation>
    </message>
    <message>
        <source>Nothing opens by itself: you carve the volume with a ball, a box or a saw until the focus shows (Wang and Kaufman 1995)</source>
        <translation>Nichts öffnet sich von selbst: Sie tragen das Volumen mit Kugel, Quader oder Säge ab, bis der Fokus zu sehen ist (Wang und Kaufman 1995)</translation>
    </message>
    <message>
        <source>Nothing is cut away: in front of the focus, and in the opening around it, what is flat gives way and edges stay, like a ghost of it; what is in focus stays as it is (Bruckner and Gröller 2005)</source>
        <translation>Nichts wird weggeschnitten: vor dem Fokus und in der Öffnung um ihn weicht Flaches, und Kanten bleiben wie ein Geisterbild; was im Fokus ist, bleibt unverändert (Bruckner und Gröller 2005)</translation>
    </message>
    <message>
        <source>The adaptive cutaway with the slices at the crosshair as walls: behind the volume, or inside the opening (Tory and Swindells 2003)</source>
        <translation>Der adaptive Freischnitt mit den Schichten am Fadenkreuz als Wänden: hinter dem Volumen oder in der Öffnung (Tory und Swindells 2003)</translation>
    </message>
    <message>
        <source>Standard</source>
        <translation>Standard</translation>
    </message>
    <message>
        <source>A little gloss</source>
        <translation>Ein wenig Glanz</translation>
    </message>
    <message>
        <source>Matte</source>
        <translation>Matt</translation>
    </message>
    <message>
        <source>Without highlights, as plaster</source>
        <translation>Ohne Glanzlichter, wie Gips</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>Knochen</translation>
    </message>
    <message>
        <source>Soft shades and a wide sheen</source>
        <translation>Weiche Schatten und ein breiter Schimmer</translation>
    </message>
    <message>
        <source>Wet</source>
        <translation>Feucht</translation>
    </message>
    <message>
        <source>Small and strong highlights, as moist tissue in an operation</source>
        <translation>Kleine und starke Glanzlichter, wie feuchtes Gewebe bei einer Operation</translation>
    </message>
    <message>
        <source>Technical</source>
        <translation>Technisch</translation>
    </message>
    <message>
        <source>Even light that keeps colours to be told apart</source>
        <translation>Gleichmäßiges Licht, in dem Farben unterscheidbar bleiben</translation>
    </message>
    <message>
        <source>As the desktop</source>
        <translation>Wie der Desktop</translation>
    </message>
    <message>
        <source>How deep the focus lies; below 0 prefers views with little in front of it.
vd1 = mean depth of the focus&apos;s pixels / diameter of the model&apos;s sphere</source>
        <translation>Wie tief der Fokus liegt; unter 0 bevorzugt Ansichten mit wenig davor.
vd1 = mittlere Tiefe der Pixel des Fokus / Durchmesser der Kugel um das Modell</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>How large the focus is in the picture.
vd2 = pixels of the focus / pixels of the picture</source>
        <translation>Wie groß der Fokus im Bild ist.
vd2 = Pixel des Fokus / Pixel des Bilds</translation>
    </message>
    <message>
        <source>Centring</source>
        <translation>Zentrierung</translation>
    </message>
    <message>
        <source>How near to the middle of the picture it is.
vd3 = 1 − distance of its centroid from the middle / distance of a corner</source>
        <translation>Wie nahe er der Bildmitte ist.
vd3 = 1 − Abstand seines Schwerpunkts von der Mitte / Abstand einer Ecke</translation>
    </message>
    <message>
        <source>Cut ends</source>
        <translation>Schnittenden</translation>
    </message>
    <message>
        <source>Below 0 avoids looking at the focus through a face where the scan cuts the body off.
Share of the focus&apos;s pixels whose rays enter the volume inside the body</source>
        <translation>Unter 0 meidet Blicke auf den Fokus durch eine Fläche, an der die Aufnahme den Körper abschneidet.
Anteil der Pixel des Fokus, deren Strahlen innerhalb des Körpers ins Volumen eintreten</translation>
    </message>
    <message>
        <source>Evenness</source>
        <translation>Gleichmaß</translation>
    </message>
    <message>
        <source>How much of its surface is seen.
Viewpoint entropy −Σ p log p of the seen surface points, over its maximum (Bordoloi, Shen 2005)</source>
        <translation>Wie viel seiner Oberfläche zu sehen ist.
Blickpunktentropie −Σ p log p der sichtbaren Oberflächenpunkte, durch ihr Maximum (Bordoloi, Shen 2005)</translation>
    </message>
    <message>
        <source>Typical</source>
        <translation>Typisch</translation>
    </message>
    <message>
        <source>How typical the view is of all views.
1 − Σ p(o|v) log(p(o|v) / p(o)) over its maximum (Viola et al. 2006)</source>
        <translation>Wie typisch die Ansicht unter allen ist.
1 − Σ p(o|v) log(p(o|v) / p(o)) durch ihr Maximum (Viola et al. 2006)</translation>
    </message>
    <message>
        <source>Steady</source>
        <translation>Stetig</translation>
    </message>
    <message>
        <source>How little changes when the camera moves a bit.
1 − Jensen–Shannon divergence to the eight nearest views</source>
        <translation>Wie wenig sich ändert, wenn sich die Kamera etwas bewegt.
1 − Jensen-Shannon-Divergenz zu den acht nächsten Ansichten</translation>
    </message>
    <message>
        <source>Standard view</source>
        <translation>Standardansicht</translation>
    </message>
    <message>
        <source>How near the view is to anterior, left, superior …: a little decides between equally good views.
Cosine of the angle to the nearest of the six</source>
        <translation>Wie nahe die Ansicht anterior, links, superior … ist: ein wenig davon entscheidet zwischen gleich guten Ansichten.
Kosinus des Winkels zur nächsten der sechs</translation>
    </message>
    <message>
        <source>Not through cut ends</source>
        <translation>Nicht durch Schnittenden</translation>
    </message>
    <message>
        <source>No view within 45° of an end of the scan where the body goes on, while another one shows at least two thirds as much of the focus</source>
        <translation>Keine Ansicht innerhalb von 45° um ein Ende der Aufnahme, wo der Körper weitergeht, solange eine andere mindestens zwei Drittel so viel vom Fokus zeigt</translation>
    </message>
    <message>
        <source>From around before from above</source>
        <translation>Von ringsum vor von oben</translation>
    </message>
    <message>
        <source>From the front, from behind, the left or the right rather than from above or below, where both show about as much</source>
        <translation>Von vorn, hinten, links oder rechts statt von oben oder unten, wo beide etwa gleich viel zeigen</translation>
    </message>
    <message>
        <source>Thin stacks from the front</source>
        <translation>Dünne Stapel von vorn</translation>
    </message>
    <message>
        <source>A stack of a few slices, or one much thinner than wide, is seen from the side from which its slices are shown, not edge-on</source>
        <translation>Ein Stapel weniger Schichten, oder einer viel dünner als breit, wird von der Seite gesehen, von der seine Schichten gezeigt werden, nicht von der Kante</translation>
    </message>
    <message>
        <source>From the near side</source>
        <translation>Von der näheren Seite</translation>
    </message>
    <message>
        <source>Language (at the next start)</source>
        <translation>Sprache (beim nächsten Start)</translation>
    </message>
    <message>
        <source>Language of the window&apos;s texts and numbers; it changes when Fenestra starts again</source>
        <translation>Sprache der Texte und Zahlen des Fensters; sie wechselt, wenn Fenestra neu startet</translation>
    </message>
    <message>
        <source>Usual side</source>
        <translation>Übliche Seite</translation>
    </message>
    <message>
        <source>How usual the view is: from the front rather than from the side, from behind, from above or below</source>
        <translation>Wie üblich die Ansicht ist: eher von vorn als von der Seite, von hinten, von oben oder unten</translation>
    </message>
    <message>
        <source>Last view</source>
        <translation>Letzte Ansicht</translation>
    </message>
    <message>
        <source>How near the view is to the present one, so that it does not jump</source>
        <translation>Wie nahe die Ansicht der jetzigen ist, damit sie nicht springt</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>How well the view shows the structure&apos;s shape around the point: onto what is flat, across what is long</source>
        <translation>Wie gut die Ansicht die Form der Struktur um den Punkt zeigt: auf Flaches, quer zu Langem</translation>
    </message>
    <message>
        <source>Unhidden</source>
        <translation>Unverdeckt</translation>
    </message>
    <message>
        <source>How little hides the structure around the point, before anything is cut away</source>
        <translation>Wie wenig die Struktur um den Punkt verdeckt, bevor etwas weggeschnitten ist</translation>
    </message>
    <message>
        <source>Neurological convention</source>
        <translation>Neurologische Konvention</translation>
    </message>
    <message>
        <source>Axial and coronal slices show the patient&apos;s left on the left; otherwise it is on the right, as radiologists have it</source>
        <translation>Axiale und koronale Schichten zeigen die linke Seite des Patienten links; sonst rechts, wie in der Radiologie üblich</translation>
    </message>
    <message>
        <source>Objects of archives, at most</source>
        <translation>Objekte aus Archiven, höchstens</translation>
    </message>
    <message>
        <source>Disk space for what was retrieved from archive servers: the series used longest ago go first</source>
        <translation>Speicherplatz für das, was von Archivservern abgerufen wurde: die am längsten nicht benutzten Serien gehen zuerst</translation>
    </message>
    <message>
        <source>GB</source>
        <translation>GB</translation>
    </message>
    <message>
        <source>de-identifying</source>
        <translation>wird anonymisiert</translation>
    </message>
    <message>
        <source>listing files</source>
        <translation>Dateien werden aufgelistet</translation>
    </message>
    <message>
        <source>looking for faces</source>
        <translation>Gesichter werden gesucht</translation>
    </message>
</context>
<context>
    <name>Slab</name>
    <message>
        <source>MIP</source>
        <translation>MIP</translation>
    </message>
    <message>
        <source>MinIP</source>
        <translation>MinIP</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>%1 %2 mm</source>
        <translation>%1 %L2 mm</translation>
    </message>
</context>
<context>
    <name>StructureMenu</name>
    <message>
        <source>Focus on %1</source>
        <translation>Fokus auf %1</translation>
    </message>
    <message>
        <source>Take %1 out of the focus</source>
        <translation>%1 aus dem Fokus nehmen</translation>
    </message>
    <message>
        <source>Add %1 to the focus</source>
        <translation>%1 zum Fokus hinzufügen</translation>
    </message>
    <message>
        <source>Grow a region from here</source>
        <translation>Region von hier wachsen lassen</translation>
    </message>
    <message>
        <source>Add this to the region</source>
        <translation>Dies zur Region hinzufügen</translation>
    </message>
    <message>
        <source>Take this away from the region</source>
        <translation>Dies aus der Region nehmen</translation>
    </message>
    <message>
        <source>Crosshair here</source>
        <translation>Fadenkreuz hierher</translation>
    </message>
    <message>
        <source>No focus</source>
        <translation>Kein Fokus</translation>
    </message>
</context>
<context>
    <name>ViewArea</name>
    <message>
        <source>&amp;Five views</source>
        <translation>&amp;Fünf Ansichten</translation>
    </message>
    <message>
        <source>C&amp;1 and C2</source>
        <translation>C&amp;1 und C2</translation>
    </message>
    <message>
        <source>&amp;3-D large, three slices</source>
        <translation>&amp;3-D groß, drei Schichten</translation>
    </message>
    <message>
        <source>&amp;Slices alone</source>
        <translation>&amp;Nur Schichten</translation>
    </message>
    <message>
        <source>&amp;Axial large</source>
        <translation>&amp;Axial groß</translation>
    </message>
    <message>
        <source>Four: C1 and slices</source>
        <translation>Vier: C1 und Schichten</translation>
    </message>
    <message>
        <source>C1 &amp;beside axial</source>
        <translation>&amp;C1 neben axial</translation>
    </message>
</context>
<context>
    <name>WayOut</name>
    <message>
        <source>File → Choose series has the others</source>
        <translation>Datei → Serie wählen enthält die anderen</translation>
    </message>
    <message>
        <source>it holds one volume: open it without a time point</source>
        <translation>sie enthält ein Volumen: öffnen Sie sie ohne Zeitpunkt</translation>
    </message>
    <message>
        <source>open it without naming a series; File → Choose series then lists those that are there</source>
        <translation>öffnen Sie sie, ohne eine Serie zu nennen; Datei → Serie wählen listet dann die vorhandenen</translation>
    </message>
    <message>
        <source>open it as a volume: a dialog asks for the size</source>
        <translation>öffnen Sie sie als Volumen: ein Dialog fragt nach der Größe</translation>
    </message>
    <message>
        <source>File → Size of the voxels says otherwise</source>
        <translation>Datei → Voxelgröße ändert das</translation>
    </message>
    <message>
        <source>open it without a size of voxels, which TIFF and raw files need</source>
        <translation>öffnen Sie sie ohne Voxelgröße, die nur TIFF und rohe Dateien brauchen</translation>
    </message>
    <message>
        <source>File → Kind of values says otherwise</source>
        <translation>Datei → Art der Werte ändert das</translation>
    </message>
    <message>
        <source>put the file into the folder of its header</source>
        <translation>legen Sie die Datei in den Ordner ihres Headers</translation>
    </message>
    <message>
        <source>open it as it is stored: Load as is, in the notice about its slices</source>
        <translation>öffnen Sie sie, wie sie gespeichert ist: Unverändert laden, im Hinweis zu ihren Schichten</translation>
    </message>
    <message>
        <source>DICOM, NIfTI, NRRD, MetaImage, MGH, Analyze and TIFF are recognised by content</source>
        <translation>DICOM, NIfTI, NRRD, MetaImage, MGH, Analyze und TIFF werden am Inhalt erkannt</translation>
    </message>
    <message>
        <source>&quot;Hide the table&quot; in the panel Context brings it back</source>
        <translation>„Tisch ausblenden“ im Panel Kontext bringt ihn zurück</translation>
    </message>
    <message>
        <source>open a label map with File → Open labels</source>
        <translation>öffnen Sie eine Labelkarte mit Datei → Labels öffnen</translation>
    </message>
    <message>
        <source>choose one in the panel Focus</source>
        <translation>wählen Sie einen im Panel Fokus</translation>
    </message>
    <message>
        <source>choose the labels of the focus in the panel Focus</source>
        <translation>wählen Sie die Labels des Fokus im Panel Fokus</translation>
    </message>
    <message>
        <source>open the session again with File → Open session, which asks where they are, or put them beside it</source>
        <translation>öffnen Sie die Sitzung erneut mit Datei → Sitzung öffnen, was nach dem Ort fragt, oder legen Sie sie daneben</translation>
    </message>
    <message>
        <source>open the session again with File → Open session, which asks where they are</source>
        <translation>öffnen Sie die Sitzung erneut mit Datei → Sitzung öffnen, was nach dem Ort fragt</translation>
    </message>
    <message>
        <source>open it without saying how its volume is read</source>
        <translation>öffnen Sie sie, ohne zu sagen, wie ihr Volumen gelesen wird</translation>
    </message>
    <message>
        <source>open it without files</source>
        <translation>öffnen Sie sie ohne Dateien</translation>
    </message>
    <message>
        <source>raise the tolerance in the panel Focus</source>
        <translation>erhöhen Sie die Toleranz im Panel Fokus</translation>
    </message>
    <message>
        <source>click at another place, or take a point outside away</source>
        <translation>klicken Sie an eine andere Stelle, oder nehmen Sie einen Punkt außerhalb weg</translation>
    </message>
    <message>
        <source>select more, or take less away</source>
        <translation>wählen Sie mehr aus, oder nehmen Sie weniger weg</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::Actions</name>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;User guide</source>
        <translation>&amp;Benutzerhandbuch</translation>
    </message>
    <message>
        <source>Guided &amp;tour</source>
        <translation>&amp;Geführte Tour</translation>
    </message>
    <message>
        <source>&amp;Keys and mouse</source>
        <translation>&amp;Tasten und Maus</translation>
    </message>
    <message>
        <source>?</source>
        <translation>?</translation>
    </message>
    <message>
        <source>&amp;About Fenestra</source>
        <translation>Über &amp;Fenestra</translation>
    </message>
    <message>
        <source>Open &amp;folder…</source>
        <translation>&amp;Ordner öffnen…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+O</source>
        <translation>Ctrl+Shift+O</translation>
    </message>
    <message>
        <source>&amp;Open file…</source>
        <translation>&amp;Datei öffnen…</translation>
    </message>
    <message>
        <source>Open &amp;labels…</source>
        <translation>&amp;Labels öffnen…</translation>
    </message>
    <message>
        <source>Ctrl+L</source>
        <translation>Ctrl+L</translation>
    </message>
    <message>
        <source>Choose series…</source>
        <translation>Serie wählen…</translation>
    </message>
    <message>
        <source>Open s&amp;ession…</source>
        <translation>S&amp;itzung öffnen…</translation>
    </message>
    <message>
        <source>&amp;Save session</source>
        <translation>Si&amp;tzung speichern</translation>
    </message>
    <message>
        <source>Save session &amp;as…</source>
        <translation>Sitzung speichern &amp;unter…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+S</source>
        <translation>Ctrl+Shift+S</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>&amp;Built-in phantoms</source>
        <translation>&amp;Eingebaute Phantome</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>Open a folder of &amp;masks…</source>
        <translation>Ordner &amp;mit Masken öffnen…</translation>
    </message>
    <message>
        <source>Open a &amp;table of labels…</source>
        <translation>L&amp;abeltabelle öffnen…</translation>
    </message>
    <message>
        <source>Si&amp;ze of the voxels…</source>
        <translation>&amp;Voxelgröße…</translation>
    </message>
    <message>
        <source>&amp;Kind of values</source>
        <translation>Art der &amp;Werte</translation>
    </message>
    <message>
        <source>&amp;CT</source>
        <translation>&amp;CT</translation>
    </message>
    <message>
        <source>&amp;MR</source>
        <translation>&amp;MR</translation>
    </message>
    <message>
        <source>&amp;PET or SPECT</source>
        <translation>&amp;PET oder SPECT</translation>
    </message>
    <message>
        <source>&amp;Ultrasound</source>
        <translation>&amp;Ultraschall</translation>
    </message>
    <message>
        <source>&amp;Other</source>
        <translation>&amp;Andere</translation>
    </message>
    <message>
        <source>Se&amp;gmentations of this series</source>
        <translation>Se&amp;gmentierungen dieser Serie</translation>
    </message>
    <message>
        <source>E&amp;xport</source>
        <translation>E&amp;xportieren</translation>
    </message>
    <message>
        <source>A &amp;picture…</source>
        <translation>&amp;Bild…</translation>
    </message>
    <message>
        <source>Ctrl+E</source>
        <translation>Ctrl+E</translation>
    </message>
    <message>
        <source>A &amp;turntable…</source>
        <translation>&amp;Drehfilm…</translation>
    </message>
    <message>
        <source>All &amp;labels…</source>
        <translation>&amp;Alle Labels…</translation>
    </message>
    <message>
        <source>The &amp;focus as labels…</source>
        <translation>&amp;Fokus als Labels…</translation>
    </message>
    <message>
        <source>The focus as a &amp;surface…</source>
        <translation>Fokus als &amp;Oberfläche…</translation>
    </message>
    <message>
        <source>&amp;Measures as a table…</source>
        <translation>&amp;Messungen als Tabelle…</translation>
    </message>
    <message>
        <source>%1, name hidden</source>
        <translation>%1, Name verborgen</translation>
    </message>
    <message>
        <source>Nothing yet</source>
        <translation>Noch nichts</translation>
    </message>
    <message>
        <source>Forget these</source>
        <translation>Diese vergessen</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Ctrl+Shift+Z</source>
        <translation>Ctrl+Shift+Z</translation>
    </message>
    <message>
        <source>&amp;Brush</source>
        <translation>&amp;Pinsel</translation>
    </message>
    <message>
        <source>P</source>
        <translation>P</translation>
    </message>
    <message>
        <source>&amp;Opposite brush</source>
        <translation>&amp;Gegenteiliger Pinsel</translation>
    </message>
    <message>
        <source>E</source>
        <translation>E</translation>
    </message>
    <message>
        <source>&amp;Smaller brush</source>
        <translation>&amp;Kleinerer Pinsel</translation>
    </message>
    <message>
        <source>[</source>
        <translation>[</translation>
    </message>
    <message>
        <source>&amp;Larger brush</source>
        <translation>Größ&amp;erer Pinsel</translation>
    </message>
    <message>
        <source>]</source>
        <translation>]</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Copy picture</source>
        <translation>&amp;Bild kopieren</translation>
    </message>
    <message>
        <source>Se&amp;ttings…</source>
        <translation>E&amp;instellungen…</translation>
    </message>
    <message>
        <source>&amp;Window/level</source>
        <translation>&amp;Fensterung</translation>
    </message>
    <message>
        <source>Of the data</source>
        <translation>Der Daten</translation>
    </message>
    <message>
        <source>1</source>
        <translation>1</translation>
    </message>
    <message>
        <source>CT %1  (%2 / %3)</source>
        <translation>CT %1  (%2 / %3)</translation>
    </message>
    <message>
        <source>By &amp;number…</source>
        <translation>&amp;Nach Zahlen…</translation>
    </message>
    <message>
        <source>W</source>
        <translation>W</translation>
    </message>
    <message>
        <source>&amp;Invert</source>
        <translation>&amp;Invertieren</translation>
    </message>
    <message>
        <source>I</source>
        <translation>I</translation>
    </message>
    <message>
        <source>&amp;Distance</source>
        <translation>&amp;Strecke</translation>
    </message>
    <message>
        <source>&amp;Angle</source>
        <translation>&amp;Winkel</translation>
    </message>
    <message>
        <source>&amp;Ellipse</source>
        <translation>&amp;Ellipse</translation>
    </message>
    <message>
        <source>&amp;Rectangle</source>
        <translation>&amp;Rechteck</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>Ctrl+Shift+C</source>
        <translation>Ctrl+Shift+C</translation>
    </message>
    <message>
        <source>De&amp;lete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>Delete all</source>
        <translation>Alle löschen</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>&amp;Messen</translation>
    </message>
    <message>
        <source>&amp;Show measures</source>
        <translation>&amp;Messungen anzeigen</translation>
    </message>
    <message>
        <source>F&amp;ocus</source>
        <translation>F&amp;okus</translation>
    </message>
    <message>
        <source>&amp;No focus</source>
        <translation>&amp;Kein Fokus</translation>
    </message>
    <message>
        <source>Ctrl+Backspace</source>
        <translation>Ctrl+Backspace</translation>
    </message>
    <message>
        <source>&amp;Click chooses the focus</source>
        <translation>Klick &amp;wählt den Fokus</translation>
    </message>
    <message>
        <source>G</source>
        <translation>G</translation>
    </message>
    <message>
        <source>&amp;Lower tolerance</source>
        <translation>&amp;Toleranz verringern</translation>
    </message>
    <message>
        <source>,</source>
        <translation>,</translation>
    </message>
    <message>
        <source>&amp;Higher tolerance</source>
        <translation>Toleranz &amp;erhöhen</translation>
    </message>
    <message>
        <source>.</source>
        <translation>.</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>V&amp;erify this picture…</source>
        <translation>&amp;Dieses Bild prüfen…</translation>
    </message>
    <message>
        <source>Computes pixels drawn at random again, in double precision, and states how exact the picture is</source>
        <translation>Berechnet zufällig gezogene Pixel mit doppelter Genauigkeit neu und gibt an, wie genau das Bild ist</translation>
    </message>
    <message>
        <source>All &amp;views</source>
        <translation>&amp;Alle Ansichten</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Full screen</source>
        <translation>Vollbild</translation>
    </message>
    <message>
        <source>F11</source>
        <translation>F11</translation>
    </message>
    <message>
        <source>Reset la&amp;yout</source>
        <translation>Anordnung &amp;zurücksetzen</translation>
    </message>
    <message>
        <source>Li&amp;ght theme</source>
        <translation>&amp;Helles Design</translation>
    </message>
    <message>
        <source>Anterior</source>
        <translation>Anterior</translation>
    </message>
    <message>
        <source>Posterior</source>
        <translation>Posterior</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Superior</source>
        <translation>Superior</translation>
    </message>
    <message>
        <source>Inferior</source>
        <translation>Inferior</translation>
    </message>
    <message>
        <source>&amp;Look from</source>
        <translation>&amp;Blick von</translation>
    </message>
    <message>
        <source>Place cameras</source>
        <translation>Kameras platzieren</translation>
    </message>
    <message>
        <source>F5</source>
        <translation>F5</translation>
    </message>
    <message>
        <source>&amp;Reset view</source>
        <translation>A&amp;nsicht zurücksetzen</translation>
    </message>
    <message>
        <source>R</source>
        <translation>R</translation>
    </message>
    <message>
        <source>Reset &amp;all views</source>
        <translation>A&amp;lle Ansichten zurücksetzen</translation>
    </message>
    <message>
        <source>Ctrl+R</source>
        <translation>Ctrl+R</translation>
    </message>
    <message>
        <source>Link the 3-D views</source>
        <translation>3-D-Ansichten koppeln</translation>
    </message>
    <message>
        <source>L</source>
        <translation>L</translation>
    </message>
    <message>
        <source>&amp;Parallel projection</source>
        <translation>&amp;Parallelprojektion</translation>
    </message>
    <message>
        <source>Ctrl+P</source>
        <translation>Ctrl+P</translation>
    </message>
    <message>
        <source>Animate the cameras</source>
        <translation>Kamerafahrten</translation>
    </message>
    <message>
        <source>&amp;Freeze the opening</source>
        <translation>Öffnung &amp;einfrieren</translation>
    </message>
    <message>
        <source>F</source>
        <translation>F</translation>
    </message>
    <message>
        <source>Freeze</source>
        <translation>Einfrieren</translation>
    </message>
    <message>
        <source>Keeps the opening where it is while the cameras move, so that they look into it (%1)</source>
        <translation>Lässt die Öffnung, wo sie ist, während die Kameras sich bewegen, sodass man in sie hineinsieht (%1)</translation>
    </message>
    <message>
        <source>&amp;Crosshair</source>
        <translation>&amp;Fadenkreuz</translation>
    </message>
    <message>
        <source>C</source>
        <translation>C</translation>
    </message>
    <message>
        <source>Label &amp;overlay</source>
        <translation>Label-Übe&amp;rlagerung</translation>
    </message>
    <message>
        <source>O</source>
        <translation>O</translation>
    </message>
    <message>
        <source>Corner &amp;text</source>
        <translation>E&amp;cktexte</translation>
    </message>
    <message>
        <source>T</source>
        <translation>T</translation>
    </message>
    <message>
        <source>&amp;Hide the patient</source>
        <translation>Patient &amp;verbergen</translation>
    </message>
    <message>
        <source>H</source>
        <translation>H</translation>
    </message>
    <message>
        <source>&amp;Quality at rest</source>
        <translation>&amp;Qualität in Ruhe</translation>
    </message>
    <message>
        <source>Bound on the error that sampling leaves in a pixel&apos;s colour</source>
        <translation>Schranke für den Fehler, den die Abtastung in der Farbe eines Pixels lässt</translation>
    </message>
    <message>
        <source>&amp;Slices</source>
        <translation>Schichten</translation>
    </message>
    <message>
        <source>Face C&amp;1</source>
        <translation>Zu C&amp;1 gewandt</translation>
    </message>
    <message>
        <source>Shift+F</source>
        <translation>Shift+F</translation>
    </message>
    <message>
        <source>Face C&amp;2</source>
        <translation>Zu C&amp;2 gewandt</translation>
    </message>
    <message>
        <source>&amp;Slab</source>
        <translation>S&amp;chichtpaket</translation>
    </message>
    <message>
        <source>&amp;Outlines in 3-D</source>
        <translation>Umrisse &amp;in 3-D</translation>
    </message>
    <message>
        <source>Shift+O</source>
        <translation>Shift+O</translation>
    </message>
    <message>
        <source>&amp;Reset the plane</source>
        <translation>&amp;Ebene zurücksetzen</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Reset &amp;all planes</source>
        <translation>Alle Ebenen &amp;zurücksetzen</translation>
    </message>
    <message>
        <source>Shift+N</source>
        <translation>Shift+N</translation>
    </message>
    <message>
        <source>&amp;Next series</source>
        <translation>&amp;Nächste Serie</translation>
    </message>
    <message>
        <source>Ctrl+PgDown</source>
        <translation>Ctrl+PgDown</translation>
    </message>
    <message>
        <source>Pre&amp;vious series</source>
        <translation>Vo&amp;rige Serie</translation>
    </message>
    <message>
        <source>Ctrl+PgUp</source>
        <translation>Ctrl+PgUp</translation>
    </message>
    <message>
        <source>&amp;Close study</source>
        <translation>Studie s&amp;chließen</translation>
    </message>
    <message>
        <source>Ctrl+W</source>
        <translation>Ctrl+W</translation>
    </message>
    <message>
        <source>Layo&amp;ut of the views</source>
        <translation>An&amp;ordnung der Ansichten</translation>
    </message>
    <message>
        <source>&amp;One view, the active one</source>
        <translation>&amp;Eine Ansicht, die aktive</translation>
    </message>
    <message>
        <source>&amp;Next view</source>
        <translation>Nächste Ansicht</translation>
    </message>
    <message>
        <source>Previous view</source>
        <translation>Vorige Ansicht</translation>
    </message>
    <message>
        <source>&amp;Keep this layout…</source>
        <translation>&amp;Diese Anordnung behalten…</translation>
    </message>
    <message>
        <source>Forget</source>
        <translation>Vergessen</translation>
    </message>
    <message>
        <source>Keep this layout</source>
        <translation>Diese Anordnung behalten</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Flip &amp;left and right</source>
        <translation>&amp;Links und rechts spiegeln</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Flip &amp;up and down</source>
        <translation>&amp;Oben und unten spiegeln</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>&amp;Turn by 90°</source>
        <translation>&amp;Um 90° drehen</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>Tru&amp;e size</source>
        <translation>&amp;Wahre Größe</translation>
    </message>
    <message>
        <source>J</source>
        <translation>J</translation>
    </message>
    <message>
        <source>This screen does not say how large it is, so that true size cannot be shown.</source>
        <translation>Dieser Bildschirm sagt nicht, wie groß er ist, sodass die wahre Größe nicht gezeigt werden kann.</translation>
    </message>
    <message>
        <source>&amp;Neurological convention</source>
        <translation>&amp;Neurologische Konvention</translation>
    </message>
    <message>
        <source>U</source>
        <translation>U</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Abspielen</translation>
    </message>
    <message>
        <source>K</source>
        <translation>K</translation>
    </message>
    <message numerus="yes">
        <source>%n slices a second</source>
        <translation>
            <numerusform>%n Schicht je Sekunde</numerusform>
            <numerusform>%n Schichten je Sekunde</numerusform>
        </translation>
    </message>
    <message>
        <source>Play &amp;faster</source>
        <translation>&amp;Schneller abspielen</translation>
    </message>
    <message>
        <source>Shift+K</source>
        <translation>Shift+K</translation>
    </message>
    <message>
        <source>Play slo&amp;wer</source>
        <translation>Lan&amp;gsamer abspielen</translation>
    </message>
    <message>
        <source>Ctrl+K</source>
        <translation>Ctrl+K</translation>
    </message>
    <message>
        <source>Ctrl+Y</source>
        <translation>Ctrl+Y</translation>
    </message>
    <message>
        <source>Change &amp;keys…</source>
        <translation>T&amp;asten ändern…</translation>
    </message>
    <message>
        <source>%1  (%2 % to %3 % of the values)</source>
        <translation>%1  (%2 % bis %3 % der Werte)</translation>
    </message>
    <message>
        <source>SUV 0 to %1</source>
        <translation>SUV 0 bis %1</translation>
    </message>
    <message>
        <source>&amp;My windows</source>
        <translation>&amp;Eigene Fenster</translation>
    </message>
    <message>
        <source>&amp;Keep this window…</source>
        <translation>&amp;Dieses Fenster behalten…</translation>
    </message>
    <message>
        <source>%1  (%2 / %3)</source>
        <translation>%1  (%2 / %3)</translation>
    </message>
    <message>
        <source>Keep this window</source>
        <translation>Dieses Fenster behalten</translation>
    </message>
    <message>
        <source>Brain</source>
        <translation>Gehirn</translation>
    </message>
    <message>
        <source>Abdomen</source>
        <translation>Abdomen</translation>
    </message>
    <message>
        <source>Mediastinum</source>
        <translation>Mediastinum</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>Knochen</translation>
    </message>
    <message>
        <source>Lung</source>
        <translation>Lunge</translation>
    </message>
    <message>
        <source>Stroke</source>
        <translation>Schlaganfall</translation>
    </message>
    <message>
        <source>Subdural</source>
        <translation>Subdural</translation>
    </message>
    <message>
        <source>Liver</source>
        <translation>Leber</translation>
    </message>
    <message>
        <source>Temporal bone</source>
        <translation>Felsenbein</translation>
    </message>
    <message>
        <source>Spine, soft tissue</source>
        <translation>Wirbelsäule, Weichteile</translation>
    </message>
    <message>
        <source>Spine, bone</source>
        <translation>Wirbelsäule, Knochen</translation>
    </message>
    <message>
        <source>Usual</source>
        <translation>Üblich</translation>
    </message>
    <message>
        <source>All but outliers</source>
        <translation>Alles außer Ausreißern</translation>
    </message>
    <message>
        <source>High contrast</source>
        <translation>Hoher Kontrast</translation>
    </message>
    <message>
        <source>Bright structures</source>
        <translation>Helle Strukturen</translation>
    </message>
    <message>
        <source>Send to archive…</source>
        <translation>An ein Archiv senden…</translation>
    </message>
    <message>
        <source>The open series and its labels, to a server of the panel Archive</source>
        <translation>Die geöffnete Serie und ihre Labels, an einen Server des Panels Archiv</translation>
    </message>
    <message>
        <source>They are kept in</source>
        <translation>Sie werden aufbewahrt in</translation>
    </message>
    <message>
        <source>V</source>
        <translation>V</translation>
    </message>
    <message>
        <source>Shift+V</source>
        <translation>Shift+V</translation>
    </message>
    <message>
        <source>Keep a key image</source>
        <translation>Schlüsselbild behalten</translation>
    </message>
    <message>
        <source>Ctrl+D</source>
        <translation>Ctrl+D</translation>
    </message>
    <message>
        <source>Save res&amp;ults…</source>
        <translation>Ergebni&amp;sse speichern…</translation>
    </message>
    <message>
        <source>Measures, segmentations, pictures and key images as DICOM objects, to a folder or an archive</source>
        <translation>Messungen, Segmentierungen, Bilder und Schlüsselbilder als DICOM-Objekte, in einen Ordner oder ein Archiv</translation>
    </message>
    <message>
        <source>Arro&amp;w</source>
        <translation>&amp;Pfeil</translation>
    </message>
    <message>
        <source>&amp;Text</source>
        <translation>&amp;Text</translation>
    </message>
    <message>
        <source>Change te&amp;xt…</source>
        <translation>Te&amp;xt ändern…</translation>
    </message>
    <message>
        <source>Draw a &amp;path</source>
        <translation>Pfa&amp;d zeichnen</translation>
    </message>
    <message>
        <source>S</source>
        <translation>S</translation>
    </message>
    <message>
        <source>Path along the &amp;focus</source>
        <translation>Pfad durch den F&amp;okus</translation>
    </message>
    <message>
        <source>Open besi&amp;de</source>
        <translation>Daneben ö&amp;ffnen</translation>
    </message>
    <message>
        <source>&amp;Folder…</source>
        <translation>&amp;Ordner…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+B</source>
        <translation>Ctrl+Shift+B</translation>
    </message>
    <message>
        <source>F&amp;ile…</source>
        <translation>&amp;Datei…</translation>
    </message>
    <message>
        <source>Ctrl+B</source>
        <translation>Ctrl+B</translation>
    </message>
    <message>
        <source>T&amp;wo studies</source>
        <translation>Z&amp;wei Studien</translation>
    </message>
    <message>
        <source>&amp;Link by patient position</source>
        <translation>Nach &amp;Patientenposition koppeln</translation>
    </message>
    <message>
        <source>M</source>
        <translation>M</translation>
    </message>
    <message>
        <source>&amp;Match points</source>
        <translation>Punkte &amp;zuordnen</translation>
    </message>
    <message>
        <source>Shift+M</source>
        <translation>Shift+M</translation>
    </message>
    <message>
        <source>&amp;Forget the pair of points</source>
        <translation>Punktepaar &amp;vergessen</translation>
    </message>
    <message>
        <source>&amp;Other study</source>
        <translation>&amp;Andere Studie</translation>
    </message>
    <message>
        <source>F6</source>
        <translation>F6</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>Panel&amp;s</translation>
    </message>
    <message>
        <source>F9</source>
        <translation>F9</translation>
    </message>
    <message>
        <source>De-identify…</source>
        <translation>De-identifizieren…</translation>
    </message>
    <message>
        <source>Copies of the open series without what names the patient</source>
        <translation>Kopien der offenen Serie ohne das, was den Patienten nennt</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::AppearancePanel</name>
    <message>
        <source>Preset</source>
        <translation>Vorgabe</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Licht</translation>
    </message>
    <message>
        <source>Ready-made light: how surfaces give it back, from wherever it comes</source>
        <translation>Fertige Beleuchtung: wie Oberflächen das Licht zurückgeben, woher es auch kommt</translation>
    </message>
    <message>
        <source>own</source>
        <translation>eigene</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::ArchiveDock</name>
    <message>
        <source>Archive</source>
        <translation>Archiv</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::ArchiveModel</name>
    <message>
        <source>Patient %1</source>
        <translation>Patient %1</translation>
    </message>
    <message>
        <source>No name</source>
        <translation>Ohne Namen</translation>
    </message>
    <message>
        <source>Study %1</source>
        <translation>Studie %1</translation>
    </message>
    <message>
        <source>Series %1</source>
        <translation>Serie %1</translation>
    </message>
    <message>
        <source>Born %1</source>
        <translation>Geboren %1</translation>
    </message>
    <message>
        <source>Sex %1</source>
        <translation>Geschlecht %1</translation>
    </message>
    <message>
        <source>Accession number %1</source>
        <translation>Accession-Nummer %1</translation>
    </message>
    <message>
        <source>Study ID %1</source>
        <translation>Studien-ID %1</translation>
    </message>
    <message>
        <source>Part of the body: %1</source>
        <translation>Körperteil: %1</translation>
    </message>
    <message>
        <source>Protocol: %1</source>
        <translation>Protokoll: %1</translation>
    </message>
    <message>
        <source>Patient, study</source>
        <translation>Patient, Studie</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Typ</translation>
    </message>
    <message>
        <source>Images</source>
        <translation>Bilder</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::ArchivePanel</name>
    <message>
        <source>No server is entered, so nothing goes over the network. Add the archive server (PACS) that holds your studies; its administrator knows what to enter.</source>
        <translation>Es ist kein Server eingetragen, deshalb geht nichts über das Netz. Tragen Sie den Archivserver (PACS) ein, der Ihre Studien hat; sein Administrator weiß, was einzutragen ist.</translation>
    </message>
    <message>
        <source>Searching…</source>
        <translation>Suche läuft…</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Abgebrochen.</translation>
    </message>
    <message>
        <source>The archive server that is asked</source>
        <translation>Der Archivserver, der gefragt wird</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>Testen</translation>
    </message>
    <message>
        <source>Asks the server whether it answers (echo), and says what is wrong</source>
        <translation>Fragt den Server, ob er antwortet (Echo), und sagt, was nicht stimmt</translation>
    </message>
    <message>
        <source>Servers</source>
        <translation>Server</translation>
    </message>
    <message>
        <source>Add, edit and remove servers</source>
        <translation>Server hinzufügen, bearbeiten und entfernen</translation>
    </message>
    <message>
        <source>Add a server…</source>
        <translation>Server hinzufügen…</translation>
    </message>
    <message>
        <source>Edit…</source>
        <translation>Bearbeiten…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove the server</source>
        <translation>Den Server entfernen</translation>
    </message>
    <message>
        <source>Remove %1?</source>
        <translation>%1 entfernen?</translation>
    </message>
    <message>
        <source>Images</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Retrieves the study or series, and opens it once it is whole (double-click, or drag onto a view)</source>
        <translation>Ruft die Studie oder Serie ab und öffnet sie, sobald sie vollständig ist (Doppelklick, oder auf eine Ansicht ziehen)</translation>
    </message>
    <message>
        <source>Retrieve</source>
        <translation>Abrufen</translation>
    </message>
    <message>
        <source>Fetches what is selected into the cache, to be opened later</source>
        <translation>Holt das Ausgewählte in den Zwischenspeicher, um es später zu öffnen</translation>
    </message>
    <message>
        <source>More…</source>
        <translation>Mehr…</translation>
    </message>
    <message>
        <source>Asks for more of the studies that match</source>
        <translation>Fragt nach weiteren der passenden Studien</translation>
    </message>
    <message>
        <source>Asking %1…</source>
        <translation>%1 wird gefragt…</translation>
    </message>
    <message>
        <source>%1 answers, in %2 ms.</source>
        <translation>%1 antwortet, in %2 ms.</translation>
    </message>
    <message>
        <source>Nothing matches. Check the spelling; an asterisk stands for any text, as in *jane*.</source>
        <translation>Nichts passt. Prüfen Sie die Schreibweise; ein Stern steht für beliebigen Text, wie in *jane*.</translation>
    </message>
    <message>
        <source>Studies: %1, of patients: %2.</source>
        <translation>Studien: %1, von Patienten: %2.</translation>
    </message>
    <message>
        <source>There are more: narrow the search, or ask for more.</source>
        <translation>Es gibt mehr: Grenzen Sie die Suche ein, oder fragen Sie nach mehr.</translation>
    </message>
    <message>
        <source>The server does not match by some of the fields.</source>
        <translation>Der Server sucht nach einigen der Felder nicht.</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::ArrivalView</name>
    <message>
        <source>Looks through the slices that have come</source>
        <translation>Blättert durch die Schichten, die schon da sind</translation>
    </message>
    <message>
        <source>Slice of those that have come</source>
        <translation>Schicht aus denen, die schon da sind</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Ausblenden</translation>
    </message>
    <message>
        <source>Shows the views again; the retrieval goes on</source>
        <translation>Zeigt wieder die Ansichten; der Abruf läuft weiter</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Stops the retrieval; what came is kept</source>
        <translation>Hält den Abruf an; was da ist, bleibt</translation>
    </message>
    <message>
        <source>Not whole: %1 of %2 images of this series are here. The study opens, with its 3-D views, once all are.</source>
        <translation>Unvollständig: %1 von %2 Bildern dieser Serie sind da. Die Studie öffnet sich mit ihren 3-D-Ansichten, sobald alle da sind.</translation>
    </message>
    <message>
        <source>All images are here. The study is being opened.</source>
        <translation>Alle Bilder sind da. Die Studie wird geöffnet.</translation>
    </message>
    <message>
        <source>Not whole: frame %1 of %2 is here. The study opens, with its 3-D views, once all are.</source>
        <translation>Unvollständig: Bild %1 von %2 ist da. Die Studie öffnet sich mit ihren 3-D-Ansichten, sobald alle da sind.</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::BestViews</name>
    <message>
        <source>One of the best viewpoints; click to look from there with C1</source>
        <translation>Einer der besten Blickpunkte; Klick: mit C1 von dort sehen</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::Brush</name>
    <message>
        <source>Nothing is open: choose a focus first</source>
        <translation>Nichts ist geöffnet: zuerst einen Fokus wählen</translation>
    </message>
    <message>
        <source>The opening is switched off</source>
        <translation>Die Öffnung ist ausgeschaltet</translation>
    </message>
    <message>
        <source>This method cuts nothing away</source>
        <translation>Diese Methode schneidet nichts weg</translation>
    </message>
    <message>
        <source>Nothing is there</source>
        <translation>Hier ist nichts</translation>
    </message>
    <message>
        <source>Nothing was removed here</source>
        <translation>Hier wurde nichts entfernt</translation>
    </message>
    <message>
        <source>The brush may not cover the focus</source>
        <translation>Der Pinsel darf den Fokus nicht verdecken</translation>
    </message>
    <message>
        <source>Open down to the focus already</source>
        <translation>Bereits bis zum Fokus geöffnet</translation>
    </message>
    <message>
        <source>The context&apos;s edges are switched off</source>
        <translation>Die Kanten des Kontexts sind ausgeschaltet</translation>
    </message>
    <message>
        <source>Edges are drawn over the focus alone</source>
        <translation>Kanten werden nur über dem Fokus gezeichnet</translation>
    </message>
    <message>
        <source>switch the opening on</source>
        <translation>Öffnung einschalten</translation>
    </message>
    <message>
        <source>open instead</source>
        <translation>stattdessen öffnen</translation>
    </message>
    <message>
        <source>let it cover the focus</source>
        <translation>Verdecken erlauben</translation>
    </message>
    <message>
        <source>restore instead</source>
        <translation>stattdessen wiederherstellen</translation>
    </message>
    <message>
        <source>switch the edges on</source>
        <translation>Kanten einschalten</translation>
    </message>
    <message>
        <source>take the adaptive cutaway</source>
        <translation>adaptiven Freischnitt nehmen</translation>
    </message>
    <message>
        <source>Open the context</source>
        <translation>Kontext öffnen</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Methode</translation>
    </message>
    <message>
        <source>Context&apos;s edges</source>
        <translation>Kanten des Kontexts</translation>
    </message>
    <message>
        <source>Brush: %1</source>
        <translation>Pinsel: %1</translation>
    </message>
    <message>
        <source>Space: %1</source>
        <translation>Leertaste: %1</translation>
    </message>
    <message>
        <source>%1 %2 mm</source>
        <translation>%1 %L2 mm</translation>
    </message>
    <message>
        <source>%1 to the surface</source>
        <translation>%1 bis zur Oberfläche</translation>
    </message>
    <message>
        <source>%1 %2 %</source>
        <translation>%1 %2 %</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::BrushPanel</name>
    <message>
        <source>Restore to the surface</source>
        <translation>Bis zur Oberfläche wiederherstellen</translation>
    </message>
    <message>
        <source>May cover the focus</source>
        <translation>Darf den Fokus verdecken</translation>
    </message>
    <message>
        <source>In the painted view only</source>
        <translation>Nur in der bemalten Ansicht</translation>
    </message>
    <message>
        <source>Paint in the 3-D views</source>
        <translation>In den 3-D-Ansichten malen</translation>
    </message>
    <message>
        <source>The left button paints; Ctrl+left drag still turns the view (P; E for the opposite brush)</source>
        <translation>Die linke Taste malt; Strg+Ziehen dreht weiterhin die Ansicht (P; E für den gegenteiligen Pinsel)</translation>
    </message>
    <message>
        <source>Restore brings back all that was removed under the brush; otherwise no more than the depth</source>
        <translation>Wiederherstellen bringt alles zurück, was unter dem Pinsel entfernt wurde; sonst höchstens bis zur Tiefe</translation>
    </message>
    <message>
        <source>Otherwise restored tissue never hides the focus</source>
        <translation>Sonst verdeckt wiederhergestelltes Gewebe nie den Fokus</translation>
    </message>
    <message>
        <source>Otherwise a stroke shows in both views</source>
        <translation>Sonst gilt ein Strich in beiden Ansichten</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Softness</source>
        <translation>Weichheit</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>Amount</source>
        <translation>Menge</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::CacheRow</name>
    <message>
        <source>Move…</source>
        <translation>Verschieben…</translation>
    </message>
    <message>
        <source>Chooses where objects are kept from now on; those of before stay where they are</source>
        <translation>Wählt, wo Objekte von jetzt an aufbewahrt werden; die früheren bleiben, wo sie sind</translation>
    </message>
    <message>
        <source>Keep objects of archives in</source>
        <translation>Objekte aus Archiven aufbewahren in</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Leeren</translation>
    </message>
    <message>
        <source>Removes all objects that were retrieved; not while some come in</source>
        <translation>Entfernt alle abgerufenen Objekte; nicht, solange welche ankommen</translation>
    </message>
    <message>
        <source>Remove all objects that were retrieved? The servers still have them, but sessions that refer to them find their data no more.</source>
        <translation>Alle abgerufenen Objekte entfernen? Die Server haben sie noch, aber Sitzungen, die sich auf sie beziehen, finden ihre Daten nicht mehr.</translation>
    </message>
    <message>
        <source>Clears…</source>
        <translation>Wird geleert…</translation>
    </message>
    <message>
        <source>Counts…</source>
        <translation>Wird gezählt…</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 in %2</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::CamerasPanel</name>
    <message>
        <source>Place cameras</source>
        <translation>Kameras platzieren</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Look for the best view of the focus and the one that complements it (F5)</source>
        <translation>Sucht die beste Ansicht des Fokus und die, die sie ergänzt (F5)</translation>
    </message>
    <message>
        <source>The two views see &lt;b&gt;%1 %&lt;/b&gt; of the focus&apos;s surface</source>
        <translation>Beide Ansichten sehen &lt;b&gt;%1 %&lt;/b&gt; der Oberfläche des Fokus</translation>
    </message>
    <message>
        <source>Needs the 3-D views</source>
        <translation>Braucht die 3-D-Ansichten</translation>
    </message>
    <message>
        <source>Looking at the focus from all sides…</source>
        <translation>Der Fokus wird von allen Seiten betrachtet…</translation>
    </message>
    <message>
        <source>Click a structure on a slice</source>
        <translation>Eine Struktur auf einer Schicht anklicken</translation>
    </message>
    <message>
        <source>Not placed yet for this focus</source>
        <translation>Für diesen Fokus noch nicht platziert</translation>
    </message>
    <message>
        <source>Choose a focus first</source>
        <translation>Zuerst einen Fokus wählen</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::Carving</name>
    <message>
        <source>Carve: %1</source>
        <translation>Abtragen: %1</translation>
    </message>
    <message>
        <source>Bend the plane</source>
        <translation>Ebene biegen</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::CarvingRows</name>
    <message>
        <source>Restore all</source>
        <translation>Alles wiederherstellen</translation>
    </message>
    <message>
        <source>Carve</source>
        <translation>Abtragen</translation>
    </message>
    <message>
        <source>The left button carves in all views when it is let go; Ctrl+left drag still turns the view</source>
        <translation>Die linke Taste trägt beim Loslassen in allen Ansichten ab; Strg+Ziehen dreht weiterhin die Ansicht</translation>
    </message>
    <message>
        <source>Brings back all that was carved away</source>
        <translation>Bringt alles zurück, was abgetragen wurde</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::ClippingPanel</name>
    <message>
        <source>Crop to a box</source>
        <translation>Auf einen Quader zuschneiden</translation>
    </message>
    <message>
        <source>Add a plane</source>
        <translation>Ebene hinzufügen</translation>
    </message>
    <message>
        <source>Cut everything off behind a plane; up to three</source>
        <translation>Schneidet alles hinter einer Ebene ab; bis zu drei</translation>
    </message>
    <message>
        <source>Flip</source>
        <translation>Umkehren</translation>
    </message>
    <message>
        <source>Keep the other side of the plane</source>
        <translation>Die andere Seite der Ebene behalten</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove the plane</source>
        <translation>Ebene entfernen</translation>
    </message>
    <message>
        <source>Clip nothing</source>
        <translation>Nichts beschneiden</translation>
    </message>
    <message>
        <source>Switch off the box, and remove all planes</source>
        <translation>Quader ausschalten und alle Ebenen entfernen</translation>
    </message>
    <message>
        <source>R – L</source>
        <translation>R – L</translation>
    </message>
    <message>
        <source>A – P</source>
        <translation>A – P</translation>
    </message>
    <message>
        <source>I – S</source>
        <translation>I – S</translation>
    </message>
    <message>
        <source>The patient&apos;s right end of the box</source>
        <translation>Rechtes Ende des Quaders (vom Patienten aus)</translation>
    </message>
    <message>
        <source>The patient&apos;s left end of the box</source>
        <translation>Linkes Ende des Quaders (vom Patienten aus)</translation>
    </message>
    <message>
        <source>The front end of the box</source>
        <translation>Vorderes Ende des Quaders</translation>
    </message>
    <message>
        <source>The back end of the box</source>
        <translation>Hinteres Ende des Quaders</translation>
    </message>
    <message>
        <source>The lower end of the box</source>
        <translation>Unteres Ende des Quaders</translation>
    </message>
    <message>
        <source>The upper end of the box</source>
        <translation>Oberes Ende des Quaders</translation>
    </message>
    <message>
        <source>Drag a plane&apos;s square to move it, and the ball at its arrow to tilt it, in any view</source>
        <translation>Das Quadrat einer Ebene verschiebt sie, die Kugel an ihrem Pfeil kippt sie, in jeder Ansicht</translation>
    </message>
    <message>
        <source>Where the plane lies along its arrow</source>
        <translation>Wo die Ebene entlang ihres Pfeils liegt</translation>
    </message>
    <message>
        <source>From the axial slice</source>
        <translation>Von der axialen Schicht</translation>
    </message>
    <message>
        <source>From the sagittal slice</source>
        <translation>Von der sagittalen Schicht</translation>
    </message>
    <message>
        <source>From the coronal slice</source>
        <translation>Von der koronalen Schicht</translation>
    </message>
    <message>
        <source>Facing camera C1</source>
        <translation>Zur Kamera C1 gewandt</translation>
    </message>
    <message>
        <source>3-D pictures show only the inside of a box along the volume&apos;s axes</source>
        <translation>3-D-Bilder zeigen nur das Innere eines Quaders entlang der Achsen des Volumens</translation>
    </message>
    <message>
        <source>As the transfer function</source>
        <translation>Wie die Transferfunktion</translation>
    </message>
    <message>
        <source>Grey, as the slices</source>
        <translation>Grau, wie die Schichten</translation>
    </message>
    <message>
        <source>What the cut faces show. Grey takes the window that the slices have now</source>
        <translation>Was die Schnittflächen zeigen. Grau nimmt das Fenster, das die Schichten jetzt haben</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Lage</translation>
    </message>
    <message>
        <source>Cut faces</source>
        <translation>Schnittflächen</translation>
    </message>
    <message>
        <source>Crop</source>
        <translation>Zuschneiden</translation>
    </message>
    <message>
        <source>Flip the clip plane</source>
        <translation>Schnittebene umkehren</translation>
    </message>
    <message>
        <source>Remove the clip plane</source>
        <translation>Schnittebene entfernen</translation>
    </message>
    <message>
        <source>Move the clip plane</source>
        <translation>Schnittebene verschieben</translation>
    </message>
    <message>
        <source>Add a clip plane</source>
        <translation>Schnittebene hinzufügen</translation>
    </message>
    <message>
        <source>Plane %1, keeps %2</source>
        <translation>Ebene %1, behält %2</translation>
    </message>
    <message>
        <source>Labels that are never clipped are chosen in the list of structures, by their role.</source>
        <translation>Labels, die nie beschnitten werden, wählt man in der Liste der Strukturen über ihre Rolle.</translation>
    </message>
    <message>
        <source>Structures that are never clipped: %1</source>
        <translation>Strukturen, die nie beschnitten werden: %1</translation>
    </message>
    <message>
        <source>Clip planes</source>
        <translation>Schnittebenen</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::ContextLayerPanel</name>
    <message>
        <source>Context edges: %1</source>
        <translation>Kanten des Kontexts: %1</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::CopyRows</name>
    <message>
        <source>Copy the &amp;value</source>
        <translation>&amp;Wert kopieren</translation>
    </message>
    <message>
        <source>&amp;Copy the rows</source>
        <translation>&amp;Zeilen kopieren</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::CutawayPanel</name>
    <message>
        <source>own</source>
        <translation>eigene</translation>
    </message>
    <message>
        <source>Ready-made border and context edges</source>
        <translation>Fertige Kombination von Rand und Kanten des Kontexts</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>Aussehen</translation>
    </message>
    <message>
        <source>Smooth edges, by several rays a pixel, are the adaptive cutaway&apos;s alone</source>
        <translation>Glatte Kanten, mit mehreren Strahlen je Pixel, hat nur der adaptive Freischnitt</translation>
    </message>
    <message>
        <source>This method has no width: it cuts nothing away</source>
        <translation>Diese Methode hat keine Breite: sie schneidet nichts weg</translation>
    </message>
    <message>
        <source>This method has no width of its own: the focus and the lens decide on it</source>
        <translation>Diese Methode hat keine eigene Breite: Fokus und Linse bestimmen sie</translation>
    </message>
    <message>
        <source>This method has no width of its own: the focus and the angle decide on it</source>
        <translation>Diese Methode hat keine eigene Breite: Fokus und Winkel bestimmen sie</translation>
    </message>
    <message>
        <source>The line of this method is the rim of its lens</source>
        <translation>Die Linie dieser Methode ist der Rand ihrer Linse</translation>
    </message>
    <message>
        <source>This method has no line: it cuts nothing away</source>
        <translation>Diese Methode hat keine Linie: sie schneidet nichts weg</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::DeidentifyDialog</name>
    <message>
        <source>removed</source>
        <translation>entfernt</translation>
    </message>
    <message>
        <source>emptied</source>
        <translation>geleert</translation>
    </message>
    <message>
        <source>replaced by a dummy</source>
        <translation>durch einen Platzhalter ersetzt</translation>
    </message>
    <message>
        <source>replaced by a new UID</source>
        <translation>durch eine neue UID ersetzt</translation>
    </message>
    <message>
        <source>cleaned</source>
        <translation>bereinigt</translation>
    </message>
    <message>
        <source>De-identify</source>
        <translation>De-identifizieren</translation>
    </message>
    <message>
        <source>Writing…</source>
        <translation>Wird geschrieben…</translation>
    </message>
    <message>
        <source>Copies of the open series, images: %1</source>
        <translation>Kopien der offenen Serie, Bilder: %1</translation>
    </message>
    <message>
        <source>All labels, as a DICOM segmentation</source>
        <translation>Alle Labels, als DICOM-Segmentierung</translation>
    </message>
    <message>
        <source>Their names go with the descriptions, unless these are cleaned</source>
        <translation>Ihre Namen fallen mit den Beschreibungen weg, wenn diese nicht bereinigt werden</translation>
    </message>
    <message>
        <source>Keep dates and times</source>
        <translation>Daten und Uhrzeiten behalten</translation>
    </message>
    <message>
        <source>As they are; with them a patient may be found</source>
        <translation>Wie sie sind; mit ihnen lässt sich ein Patient finden</translation>
    </message>
    <message>
        <source>Keep UIDs</source>
        <translation>UIDs behalten</translation>
    </message>
    <message>
        <source>As they are; whoever has the originals can tell which is which</source>
        <translation>Wie sie sind; wer die Originale hat, kann sie zuordnen</translation>
    </message>
    <message>
        <source>Clean descriptions</source>
        <translation>Beschreibungen bereinigen</translation>
    </message>
    <message>
        <source>Of descriptions, the words stay that say nothing about a person; otherwise they go</source>
        <translation>Von Beschreibungen bleiben die Wörter, die nichts über eine Person sagen; sonst fallen sie weg</translation>
    </message>
    <message>
        <source>Clean graphics</source>
        <translation>Grafik bereinigen</translation>
    </message>
    <message>
        <source>The shapes of annotations stay; overlays and curves go in any case</source>
        <translation>Die Formen von Anmerkungen bleiben; Overlays und Kurven fallen in jedem Fall weg</translation>
    </message>
    <message>
        <source>Remove the face, from a head in CT or MR</source>
        <translation>Gesicht entfernen, aus einem Kopf in CT oder MR</translation>
    </message>
    <message>
        <source>All in front of a plane from the brow to the chin is blanked. Look at the copies, as slices and in 3-D: a nodded or turned head may keep a part of its face, or lose some brain</source>
        <translation>Alles vor einer Ebene von der Braue bis zum Kinn wird gelöscht. Sehen Sie die Kopien an, als Schichten und in 3D: Ein geneigter oder gedrehter Kopf behält vielleicht einen Teil des Gesichts oder verliert etwas Gehirn</translation>
    </message>
    <message>
        <source>Look at the copies before you give them away: no program finds a name that is written into a picture, or knows whether all of a face is gone.</source>
        <translation>Sehen Sie die Kopien an, bevor Sie sie weitergeben: Kein Programm findet einen Namen, der ins Bild geschrieben ist, oder weiß, ob ein Gesicht ganz fort ist.</translation>
    </message>
    <message>
        <source>What changes</source>
        <translation>Was sich ändert</translation>
    </message>
    <message>
        <source>Attribute</source>
        <translation>Attribut</translation>
    </message>
    <message>
        <source>Becomes</source>
        <translation>Wird</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen…</translation>
    </message>
    <message>
        <source>To a new folder in</source>
        <translation>In einen neuen Ordner in</translation>
    </message>
    <message>
        <source>A folder named de-identified is made there</source>
        <translation>Dort entsteht ein Ordner namens de-identified</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>To the archive</source>
        <translation>In das Archiv</translation>
    </message>
    <message>
        <source>The server answers for each object</source>
        <translation>Der Server antwortet zu jedem Objekt</translation>
    </message>
    <message>
        <source>Server</source>
        <translation>Server</translation>
    </message>
    <message>
        <source>Keep a map in the file</source>
        <translation>Zuordnung behalten in der Datei</translation>
    </message>
    <message>
        <source>Old and new UIDs and patients&apos; numbers, readable by you alone. Without it nobody can tell which was which</source>
        <translation>Alte und neue UIDs und Patientennummern, nur für Sie lesbar. Ohne sie kann niemand sie zuordnen</translation>
    </message>
    <message>
        <source>File of the map</source>
        <translation>Datei der Zuordnung</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Folder of the copies</source>
        <translation>Ordner der Kopien</translation>
    </message>
    <message>
        <source>Tables</source>
        <translation>Tabellen</translation>
    </message>
    <message>
        <source>%1 copies are in %2.</source>
        <translation>%1 Kopien liegen in %2.</translation>
    </message>
    <message>
        <source>Copy %1</source>
        <translation>Kopie %1</translation>
    </message>
    <message>
        <source>Copies without the face: %1. Look at each of them.</source>
        <translation>Kopien ohne Gesicht: %1. Sehen Sie jede an.</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::DockFolding</name>
    <message>
        <source>Fold %1</source>
        <translation>%1 einklappen</translation>
    </message>
    <message>
        <source>Folds this panel to its title, so that others have more room</source>
        <translation>Klappt dieses Panel auf seinen Titel ein, damit andere mehr Platz haben</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::Document</name>
    <message>
        <source>%1×%2×%3 · %4×%5×%6 mm</source>
        <translation>%1×%2×%3 · %L4×%L5×%L6 mm</translation>
    </message>
    <message>
        <source>Focus</source>
        <translation>Fokus</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Rolle</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Transfer function</source>
        <translation>Transferfunktion</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Verschiebung</translation>
    </message>
    <message>
        <source>Never clipped</source>
        <translation>Nie beschnitten</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Region</translation>
    </message>
    <message>
        <source>Size of the region</source>
        <translation>Größe der Region</translation>
    </message>
    <message>
        <source>Add to the region</source>
        <translation>Zur Region hinzufügen</translation>
    </message>
    <message>
        <source>Take away from the region</source>
        <translation>Aus der Region nehmen</translation>
    </message>
    <message>
        <source>Paint the region</source>
        <translation>Region malen</translation>
    </message>
    <message>
        <source>Erase from the region</source>
        <translation>Aus der Region radieren</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>The focus before still shows, until you open to the region</source>
        <translation>Noch ist der vorige Fokus zu sehen, bis Sie zur Region öffnen</translation>
    </message>
    <message>
        <source>Growing the region; the focus before still shows</source>
        <translation>Die Region wächst; noch ist der vorige Fokus zu sehen</translation>
    </message>
    <message>
        <source>Growing the region; this is a first part</source>
        <translation>Die Region wächst; dies ist ein erster Teil</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::Exports</name>
    <message>
        <source>NRRD, with names and colours</source>
        <translation>NRRD, mit Namen und Farben</translation>
    </message>
    <message>
        <source>DICOM segmentation, with names and colours</source>
        <translation>DICOM-Segmentierung, mit Namen und Farben</translation>
    </message>
    <message>
        <source>NIfTI</source>
        <translation>NIfTI</translation>
    </message>
    <message>
        <source>MetaImage</source>
        <translation>MetaImage</translation>
    </message>
    <message>
        <source>Export all labels</source>
        <translation>Alle Labels exportieren</translation>
    </message>
    <message>
        <source>Export the focus as labels</source>
        <translation>Fokus als Labels exportieren</translation>
    </message>
    <message>
        <source>%1 in mm, %2 axes</source>
        <translation>%1 in mm, Achsen %2</translation>
    </message>
    <message>
        <source>Export the focus as a surface</source>
        <translation>Fokus als Oberfläche exportieren</translation>
    </message>
    <message>
        <source>Table (CSV)</source>
        <translation>Tabelle (CSV)</translation>
    </message>
    <message>
        <source>Export the measures</source>
        <translation>Messungen exportieren</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Region</translation>
    </message>
    <message>
        <source>Wrote %1</source>
        <translation>%1 geschrieben</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::FileOpener</name>
    <message>
        <source>Open as volume</source>
        <translation>Als Volumen öffnen</translation>
    </message>
    <message>
        <source>Open as labels of this volume</source>
        <translation>Als Labels dieses Volumens öffnen</translation>
    </message>
    <message>
        <source>Volumes (*.dcm %1);;All files (*)</source>
        <translation>Volumen (*.dcm %1);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Open a volume</source>
        <translation>Volumen öffnen</translation>
    </message>
    <message>
        <source>Open a DICOM folder</source>
        <translation>DICOM-Ordner öffnen</translation>
    </message>
    <message>
        <source>Label maps (*.dcm %1);;All files (*)</source>
        <translation>Labelkarten (*.dcm %1);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Open a label map</source>
        <translation>Labelkarte öffnen</translation>
    </message>
    <message>
        <source>Open a folder of masks</source>
        <translation>Ordner mit Masken öffnen</translation>
    </message>
    <message>
        <source>Tables of labels (*.txt *.tsv *.csv *.label *.ctbl *.lut);;All files (*)</source>
        <translation>Labeltabellen (*.txt *.tsv *.csv *.label *.ctbl *.lut);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Open a table of labels</source>
        <translation>Labeltabelle öffnen</translation>
    </message>
    <message>
        <source>How large the voxels are:</source>
        <translation>Wie groß die Voxel sind:</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::FocusPanel</name>
    <message>
        <source>No labels. Click a structure in a picture, open a label map (Ctrl+L), or choose a range of values below.</source>
        <translation>Keine Labels. Klicken Sie eine Struktur in einem Bild an, öffnen Sie eine Labelkarte (Strg+L), oder wählen Sie unten einen Wertebereich.</translation>
    </message>
    <message>
        <source>Focus on values</source>
        <translation>Fokus auf Werte</translation>
    </message>
    <message>
        <source>Find a structure</source>
        <translation>Struktur suchen</translation>
    </message>
    <message>
        <source>The focus is everything whose value lies in this range</source>
        <translation>Fokus ist alles, dessen Wert in diesem Bereich liegt</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>Without islands below</source>
        <translation>Ohne Inseln unter</translation>
    </message>
    <message>
        <source>Paint the region</source>
        <translation>Region malen</translation>
    </message>
    <message>
        <source>The left button paints the region in focus in all views; with Shift it erases</source>
        <translation>Die linke Taste malt in allen Ansichten die Region im Fokus; mit Umschalt radiert sie</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Softness</source>
        <translation>Weichheit</translation>
    </message>
    <message>
        <source>Nothing open</source>
        <translation>Nichts geöffnet</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::GuideWindow</name>
    <message>
        <source>Not on this page</source>
        <translation>Nicht auf dieser Seite</translation>
    </message>
    <message>
        <source>User guide of Fenestra</source>
        <translation>Benutzerhandbuch von Fenestra</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Alt+Left</source>
        <translation>Alt+Left</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Vor</translation>
    </message>
    <message>
        <source>Alt+Right</source>
        <translation>Alt+Right</translation>
    </message>
    <message>
        <source>Previous</source>
        <translation>Voriges</translation>
    </message>
    <message>
        <source>Shift+F3</source>
        <translation>Shift+F3</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>F3</source>
        <translation>F3</translation>
    </message>
    <message>
        <source>Find on this page</source>
        <translation>Auf dieser Seite suchen</translation>
    </message>
    <message>
        <source>Return goes to the next place (Ctrl+F)</source>
        <translation>Eingabe geht zur nächsten Stelle (Strg+F)</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::ImportanceList</name>
    <message>
        <source>What hides a label of a higher level is opened for it; what has the same level or a higher one never is. All else has level 0.</source>
        <translation>Was ein Label einer höheren Stufe verdeckt, wird dafür geöffnet; was dieselbe oder eine höhere Stufe hat, nie. Alles andere hat Stufe 0.</translation>
    </message>
    <message>
        <source>Another label…</source>
        <translation>Weiteres Label…</translation>
    </message>
    <message>
        <source>Gives a label that is not in focus a level of importance</source>
        <translation>Gibt einem Label, das nicht im Fokus ist, eine Wichtigkeitsstufe</translation>
    </message>
    <message>
        <source>Level of importance</source>
        <translation>Wichtigkeitsstufe</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::KeyBindings</name>
    <message>
        <source>It is not JSON, from character %1 on: %2.</source>
        <translation>Es ist kein JSON, ab Zeichen %1: %2.</translation>
    </message>
    <message>
        <source>It does not hold Fenestra&apos;s keys: choose a file that Export in this dialog wrote.</source>
        <translation>Sie enthält nicht Fenestras Tasten: wählen Sie eine Datei, die Exportieren in diesem Dialog geschrieben hat.</translation>
    </message>
    <message>
        <source>It was written by a newer version of Fenestra.</source>
        <translation>Eine neuere Version von Fenestra hat sie geschrieben.</translation>
    </message>
    <message>
        <source>&quot;%1&quot;, of &quot;%2&quot;, is no key.</source>
        <translation>„%1“, von „%2“, ist keine Taste.</translation>
    </message>
    <message>
        <source>%1, of &quot;%2&quot;, is a key of the views.</source>
        <translation>%1, von „%2“, ist eine Taste der Ansichten.</translation>
    </message>
    <message>
        <source>%1 is the key of both &quot;%2&quot; and &quot;%3&quot;.</source>
        <translation>%1 ist die Taste von „%2“ und von „%3“.</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::KeyImages</name>
    <message>
        <source>Key image %1</source>
        <translation>Schlüsselbild %1</translation>
    </message>
    <message>
        <source>Keep a key image</source>
        <translation>Schlüsselbild behalten</translation>
    </message>
    <message>
        <source>Return to a key image</source>
        <translation>Zu einem Schlüsselbild zurück</translation>
    </message>
    <message>
        <source>Rename a key image</source>
        <translation>Schlüsselbild umbenennen</translation>
    </message>
    <message>
        <source>Delete a key image</source>
        <translation>Schlüsselbild löschen</translation>
    </message>
    <message>
        <source>Move a key image</source>
        <translation>Schlüsselbild verschieben</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::KeyImagesPanel</name>
    <message>
        <source>&amp;Keep</source>
        <translation>&amp;Behalten</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>Key images</source>
        <translation>Schlüsselbilder</translation>
    </message>
    <message>
        <source>Keeps the cameras, slices, crosshair, focus and look as they are now</source>
        <translation>Behält Kameras, Schichten, Fadenkreuz, Fokus und Aussehen, wie sie jetzt sind</translation>
    </message>
    <message>
        <source>Moves the key image up</source>
        <translation>Schiebt das Schlüsselbild nach oben</translation>
    </message>
    <message>
        <source>Moves the key image down</source>
        <translation>Schiebt das Schlüsselbild nach unten</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::KeysDialog</name>
    <message>
        <source>Change keys</source>
        <translation>Tasten ändern</translation>
    </message>
    <message>
        <source>Show entries with these words or keys</source>
        <translation>Einträge mit diesen Wörtern oder Tasten zeigen</translation>
    </message>
    <message>
        <source>Menu</source>
        <translation>Menü</translation>
    </message>
    <message>
        <source>Entry</source>
        <translation>Eintrag</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>&amp;Take it</source>
        <translation>Ü&amp;bernehmen</translation>
    </message>
    <message>
        <source>Gives the key to this entry, and the other one loses it</source>
        <translation>Gibt diesem Eintrag die Taste, und der andere verliert sie</translation>
    </message>
    <message>
        <source>&amp;No key</source>
        <translation>&amp;Keine Taste</translation>
    </message>
    <message>
        <source>As it &amp;was</source>
        <translation>&amp;Wie zuvor</translation>
    </message>
    <message>
        <source>The key that the entry comes with</source>
        <translation>Die Taste, mit der der Eintrag kommt</translation>
    </message>
    <message>
        <source>&amp;Key</source>
        <translation>&amp;Taste</translation>
    </message>
    <message>
        <source>&amp;All as they were</source>
        <translation>&amp;Alle wie zuvor</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportieren…</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>&amp;Importieren…</translation>
    </message>
    <message>
        <source>Click into the box and press the key. Changed keys are bold.</source>
        <translation>Klicken Sie in das Feld und drücken Sie die Taste. Geänderte Tasten sind fett.</translation>
    </message>
    <message>
        <source>%1 is a key of the views: no entry can have it.</source>
        <translation>%1 ist eine Taste der Ansichten: kein Eintrag kann sie haben.</translation>
    </message>
    <message>
        <source>%1 is the key of %2 → %3. Take it?</source>
        <translation>%1 ist die Taste von %2 → %3. Übernehmen?</translation>
    </message>
    <message>
        <source>Export keys</source>
        <translation>Tasten exportieren</translation>
    </message>
    <message>
        <source>Written to %1.</source>
        <translation>In %1 geschrieben.</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2. Choose another folder.</source>
        <translation>%1 lässt sich nicht schreiben: %2. Wählen Sie einen anderen Ordner.</translation>
    </message>
    <message>
        <source>Import keys</source>
        <translation>Tasten importieren</translation>
    </message>
    <message>
        <source>Keys (*.json);;All files (*)</source>
        <translation>Tasten (*.json);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>%1 cannot be read: %2.</source>
        <translation>%1 lässt sich nicht lesen: %2.</translation>
    </message>
    <message>
        <source>Taken over from %1.</source>
        <translation>Aus %1 übernommen.</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::LabelEditPanel</name>
    <message>
        <source>Grow</source>
        <translation>Wachsen</translation>
    </message>
    <message>
        <source>Add what lies within this distance; other labels keep their voxels</source>
        <translation>Fügt hinzu, was innerhalb dieses Abstands liegt; andere Labels behalten ihre Voxel</translation>
    </message>
    <message>
        <source>Shrink</source>
        <translation>Schrumpfen</translation>
    </message>
    <message>
        <source>Remove what lies within this distance of the outside</source>
        <translation>Entfernt, was innerhalb dieses Abstands von außen liegt</translation>
    </message>
    <message>
        <source>Remove islands</source>
        <translation>Inseln entfernen</translation>
    </message>
    <message>
        <source>Remove separate parts smaller than this</source>
        <translation>Entfernt getrennte Teile, die kleiner sind</translation>
    </message>
    <message>
        <source>Fill holes</source>
        <translation>Löcher füllen</translation>
    </message>
    <message>
        <source>Add what the label encloses</source>
        <translation>Fügt hinzu, was das Label umschließt</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::LabelEditor</name>
    <message>
        <source>Grow label</source>
        <translation>Label wachsen lassen</translation>
    </message>
    <message>
        <source>Shrink label</source>
        <translation>Label schrumpfen</translation>
    </message>
    <message>
        <source>Fill holes</source>
        <translation>Löcher füllen</translation>
    </message>
    <message>
        <source>Remove islands</source>
        <translation>Inseln entfernen</translation>
    </message>
    <message>
        <source>Keep region</source>
        <translation>Region behalten</translation>
    </message>
    <message>
        <source>All 65535 values that a label may have are in use</source>
        <translation>Alle 65535 Werte, die ein Label haben kann, sind vergeben</translation>
    </message>
    <message>
        <source>Nothing would be left of the label</source>
        <translation>Vom Label bliebe nichts übrig</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::LabelList</name>
    <message>
        <source>No structure&apos;s name has these words.</source>
        <translation>Keine Struktur heißt so.</translation>
    </message>
    <message>
        <source>Show the label</source>
        <translation>Label anzeigen</translation>
    </message>
    <message>
        <source>Do not show the label</source>
        <translation>Label nicht anzeigen</translation>
    </message>
    <message>
        <source>Colour of the label</source>
        <translation>Farbe des Labels</translation>
    </message>
    <message>
        <source>Focus</source>
        <translation>Fokus</translation>
    </message>
    <message>
        <source>What the view opens to</source>
        <translation>Wozu sich die Ansicht öffnet</translation>
    </message>
    <message>
        <source>Never clipped</source>
        <translation>Nie beschnitten</translation>
    </message>
    <message>
        <source>Stays outside the crop box and behind clip planes, as part of the context</source>
        <translation>Bleibt außerhalb des Quaders und hinter Schnittebenen stehen, als Teil des Kontexts</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Colour…</source>
        <translation>Farbe…</translation>
    </message>
    <message>
        <source>The label map&apos;s own colour</source>
        <translation>Eigene Farbe der Labelkarte</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Structures</source>
        <translation>Strukturen</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::LabelModel</name>
    <message>
        <source>Label %1</source>
        <translation>Label %1</translation>
    </message>
    <message>
        <source>Label %1. Tick it to open the view to it; double-click to focus on it alone and go there; F2 renames it.</source>
        <translation>Label %1. Anhaken öffnet die Ansicht dazu; Doppelklick macht es allein zum Fokus und geht dorthin; F2 benennt es um.</translation>
    </message>
    <message>
        <source>Click to choose another colour</source>
        <translation>Klick wählt eine andere Farbe</translation>
    </message>
    <message>
        <source>Click to show it or not: slices tint what is visible, and 3-D pictures draw it while it is in focus or protected</source>
        <translation>Klick zeigt es oder nicht: Schichten färben Sichtbares, und 3-D-Bilder zeichnen es, wenn es im Fokus oder geschützt ist</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Focus: what the view opens to</source>
        <translation>Fokus: wozu sich die Ansicht öffnet</translation>
    </message>
    <message>
        <source>Opacity of its surface, however thick it is, and of its tint on slices; click to change it. At 0 % it is left out of the 3-D pictures.</source>
        <translation>Deckkraft seiner Oberfläche, wie dick es auch ist, und seiner Tönung auf Schichten; Klick ändert sie. Bei 0 % fehlt es in den 3-D-Bildern.</translation>
    </message>
    <message>
        <source>C1 sees %1 of its surface, C2 %2, both together %3: measured where cameras are tried, nearest to these</source>
        <translation>C1 sieht %1 seiner Oberfläche, C2 %2, beide zusammen %3: gemessen bei den nächstgelegenen geprüften Kameras</translation>
    </message>
    <message>
        <source>Share of its surface that C1 and C2 see; measured for labels in focus when cameras are placed</source>
        <translation>Anteil seiner Oberfläche, den C1 und C2 sehen; für Labels im Fokus gemessen, wenn Kameras platziert werden</translation>
    </message>
    <message numerus="yes">
        <source>%n label(s) without voxels</source>
        <translation>
            <numerusform>%n Label ohne Voxel</numerusform>
            <numerusform>%n Labels ohne Voxel</numerusform>
        </translation>
    </message>
    <message>
        <source>Structure</source>
        <translation>Struktur</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>Seen</source>
        <translation>Gesehen</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::LabelTable</name>
    <message>
        <source>&amp;Copy all (CSV)</source>
        <translation>Alles &amp;kopieren (CSV)</translation>
    </message>
    <message>
        <source>&amp;Save…</source>
        <translation>&amp;Speichern…</translation>
    </message>
    <message>
        <source>Label table</source>
        <translation>Labeltabelle</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>Mean, %1</source>
        <translation>Mittel, %1</translation>
    </message>
    <message>
        <source>Structure</source>
        <translation>Struktur</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>SD</source>
        <translation>SD</translation>
    </message>
    <message>
        <source>Extent, mm</source>
        <translation>Ausdehnung, mm</translation>
    </message>
    <message>
        <source>Seen, C1</source>
        <translation>Sichtbar, C1</translation>
    </message>
    <message>
        <source>Seen, C2</source>
        <translation>Sichtbar, C2</translation>
    </message>
    <message>
        <source>Sides of its box along the patient: left to right, front to back, foot to head</source>
        <translation>Seiten des Quaders um das Label entlang des Patienten: links-rechts, vorn-hinten, Fuß-Kopf</translation>
    </message>
    <message>
        <source>Share of its surface that the camera sees; measured for labels in focus when cameras are placed</source>
        <translation>Anteil der Oberfläche, den die Kamera sieht; gemessen für Labels im Fokus, wenn Kameras platziert werden</translation>
    </message>
    <message>
        <source>Label %1</source>
        <translation>Label %1</translation>
    </message>
    <message>
        <source>This study has no labels. Open some from the File menu, or keep a grown region as a label.</source>
        <translation>Diese Studie hat keine Labels. Öffnen Sie welche im Menü Datei, oder behalten Sie eine gewachsene Region als Label.</translation>
    </message>
    <message>
        <source>Measuring the labels…</source>
        <translation>Labels werden gemessen…</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Save the label table</source>
        <translation>Labeltabelle speichern</translation>
    </message>
    <message>
        <source>Table (CSV)</source>
        <translation>Tabelle (CSV)</translation>
    </message>
    <message>
        <source>Written to %1.</source>
        <translation>Nach %1 geschrieben.</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::LoadingBar</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::MainWindow</name>
    <message>
        <source>Growing the region</source>
        <translation>Region wächst</translation>
    </message>
    <message>
        <source>Editing the label</source>
        <translation>Label wird bearbeitet</translation>
    </message>
    <message>
        <source>Verifying the picture</source>
        <translation>Bild wird geprüft</translation>
    </message>
    <message>
        <source>Opening…</source>
        <translation>Wird geöffnet…</translation>
    </message>
    <message>
        <source>Writing…</source>
        <translation>Wird geschrieben…</translation>
    </message>
    <message>
        <source>%1 was named at the start and is not open.</source>
        <translation>%1 wurde beim Start genannt und ist nicht geöffnet.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Other data</source>
        <translation>Andere Daten</translation>
    </message>
    <message>
        <source>Place cameras</source>
        <translation>Kameras platzieren</translation>
    </message>
    <message>
        <source>The region is %1, which is %2 % of the body. The slices show its outline; open the 3-D views to it?</source>
        <translation>Die Region umfasst %1, das sind %2 % des Körpers. Die Schichten zeigen ihren Umriss; sollen sich die 3-D-Ansichten dazu öffnen?</translation>
    </message>
    <message>
        <source>The region, %1, has a doubtful border. The slices show its outline; open the 3-D views to it?</source>
        <translation>Die Region, %1, hat einen zweifelhaften Rand. Die Schichten zeigen ihren Umriss; sollen sich die 3-D-Ansichten dazu öffnen?</translation>
    </message>
    <message>
        <source>Open to it</source>
        <translation>Dazu öffnen</translation>
    </message>
    <message>
        <source>Take it back</source>
        <translation>Zurücknehmen</translation>
    </message>
    <message>
        <source>%1 lies over other labels and took %2 from them; undo brings them back.</source>
        <translation>%1 liegt über anderen Labels und nahm ihnen %2; Rückgängig bringt sie zurück.</translation>
    </message>
    <message>
        <source>There are %1 key images; delete some to keep another.</source>
        <translation>Es gibt %1 Schlüsselbilder; löschen Sie einige, um ein weiteres zu behalten.</translation>
    </message>
    <message>
        <source>The patient may lie differently in the two studies: linked without a pair of points, the same coordinates may be other places. Unlink, put both crosshairs onto the same point, and choose Match points; the link is as good as that pair.</source>
        <translation>Der Patient kann in den beiden Studien anders liegen: Ohne Punktepaar können gleiche Koordinaten andere Stellen sein. Lösen Sie die Kopplung, setzen Sie beide Fadenkreuze auf denselben Punkt und wählen Sie Punkte zuordnen; die Kopplung ist so gut wie dieses Paar.</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::MeasureMode</name>
    <message>
        <source>Delete measure</source>
        <translation>Messung löschen</translation>
    </message>
    <message>
        <source>Delete all measures</source>
        <translation>Alle Messungen löschen</translation>
    </message>
    <message>
        <source>Move measure</source>
        <translation>Messung verschieben</translation>
    </message>
    <message>
        <source>Change text</source>
        <translation>Text ändern</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::NoticeBar</name>
    <message numerus="yes">
        <source>%n more</source>
        <translation>
            <numerusform>%n weitere</numerusform>
            <numerusform>%n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>Ausblenden</translation>
    </message>
    <message>
        <source>Files…</source>
        <translation>Dateien…</translation>
    </message>
    <message>
        <source>Files concerned</source>
        <translation>Betroffene Dateien</translation>
    </message>
    <message>
        <source>Slices scanned: %1, %2 mm apart for the most part
Planes shown: %3, %4 mm apart
Farthest from its place as shown: %5 mm; with the slices spread evenly: %6 mm
Planes in wide gaps: %7
Voxels outside of what was scanned: %8</source>
        <translation>Aufgenommene Schichten: %1, meist im Abstand von %L2 mm
Gezeigte Ebenen: %3, im Abstand von %L4 mm
Größter Abstand vom wahren Ort, wie gezeigt: %L5 mm; bei gleichmäßig verteilten Schichten: %L6 mm
Ebenen in weiten Lücken: %7
Voxel außerhalb des Aufgenommenen: %8</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Bericht…</translation>
    </message>
    <message>
        <source>Geometry report</source>
        <translation>Geometriebericht</translation>
    </message>
    <message>
        <source>Load as is</source>
        <translation>Unverändert laden</translation>
    </message>
    <message>
        <source>Regularise</source>
        <translation>Regularisieren</translation>
    </message>
    <message>
        <source>Make straight</source>
        <translation>Geraderichten</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::PathCameras</name>
    <message>
        <source>Cameras follow the path</source>
        <translation>Kameras folgen dem Pfad</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::PathMode</name>
    <message>
        <source>Draw a path</source>
        <translation>Pfad zeichnen</translation>
    </message>
    <message>
        <source>Move a point of the path</source>
        <translation>Punkt des Pfades verschieben</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::PathOpening</name>
    <message>
        <source>Radius of the opening</source>
        <translation>Radius der Öffnung</translation>
    </message>
    <message>
        <source>Opening along the path</source>
        <translation>Öffnung entlang des Pfads</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::PictureDialog</name>
    <message>
        <source>C%1</source>
        <translation>C%1</translation>
    </message>
    <message>
        <source>Both 3-D views</source>
        <translation>Beide 3-D-Ansichten</translation>
    </message>
    <message>
        <source>All views</source>
        <translation>Alle Ansichten</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>With crosshair, text and scale</source>
        <translation>Mit Fadenkreuz, Text und Maßstab</translation>
    </message>
    <message>
        <source>Save a picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>Save a turntable</source>
        <translation>Drehfilm speichern</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>Ansichten</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Pictures in a turn</source>
        <translation>Bilder je Umdrehung</translation>
    </message>
    <message>
        <source>Pictures a second</source>
        <translation>Bilder je Sekunde</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::PictureExports</name>
    <message>
        <source>Save a picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>PNG</source>
        <translation>PNG</translation>
    </message>
    <message>
        <source>No 3-D view is on screen that could turn.</source>
        <translation>Keine 3-D-Ansicht ist zu sehen, die sich drehen könnte.</translation>
    </message>
    <message>
        <source>PNG, one for each picture</source>
        <translation>PNG, eines für jedes Bild</translation>
    </message>
    <message>
        <source>MP4 film</source>
        <translation>MP4-Film</translation>
    </message>
    <message>
        <source>Save a turntable</source>
        <translation>Drehfilm speichern</translation>
    </message>
    <message>
        <source>Drawing %1…</source>
        <translation>%1 wird gezeichnet…</translation>
    </message>
    <message>
        <source>%1 exists already: choose another name, or delete the pictures of an earlier turntable.</source>
        <translation>%1 gibt es schon: wählen Sie einen anderen Namen, oder löschen Sie die Bilder eines früheren Drehfilms.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Wrote %1</source>
        <translation>%1 geschrieben</translation>
    </message>
    <message>
        <source>Copied the picture</source>
        <translation>Bild kopiert</translation>
    </message>
    <message>
        <source>ffmpeg cannot be started; save PNGs instead.</source>
        <translation>ffmpeg lässt sich nicht starten; speichern Sie stattdessen PNGs.</translation>
    </message>
    <message>
        <source>ffmpeg could not write %1: %2</source>
        <translation>ffmpeg konnte %1 nicht schreiben: %2</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2</source>
        <translation>%1 lässt sich nicht schreiben: %2</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::PictureMaker</name>
    <message>
        <source>There is no memory for a picture of %1 × %2 pixels.</source>
        <translation>Für ein Bild von %1 × %2 Pixeln fehlt Speicher.</translation>
    </message>
    <message>
        <source>C%1</source>
        <translation>C%1</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::PlacementController</name>
    <message>
        <source>The focus cannot be measured: %1</source>
        <translation>Der Fokus lässt sich nicht vermessen: %1</translation>
    </message>
    <message>
        <source>No view of that point: %1</source>
        <translation>Keine Ansicht dieses Punkts: %1</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::PlacementForm</name>
    <message>
        <source>Place the cameras when a focus is chosen</source>
        <translation>Kameras platzieren, wenn ein Fokus gewählt wird</translation>
    </message>
    <message>
        <source>Second view follows the first</source>
        <translation>Zweite Ansicht folgt der ersten</translation>
    </message>
    <message>
        <source>Find both views together</source>
        <translation>Beide Ansichten zusammen suchen</translation>
    </message>
    <message>
        <source>The focus</source>
        <translation>Der Fokus</translation>
    </message>
    <message>
        <source>A point clicked on a slice</source>
        <translation>Ein auf einer Schicht angeklickter Punkt</translation>
    </message>
    <message>
        <source>What the cameras look at.
The focus: its best view and one that complements it.
A point clicked on a slice: a click there turns both views to the structure at that point, which needs no label (LiveSync, Kohlmann et al. 2007)</source>
        <translation>Worauf die Kameras blicken.
Der Fokus: seine beste Ansicht und eine, die sie ergänzt.
Ein auf einer Schicht angeklickter Punkt: ein Klick dort wendet beide Ansichten der Struktur an diesem Punkt zu, die kein Label braucht (LiveSync, Kohlmann et al. 2007)</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>How far from the point its structure counts</source>
        <translation>Bis zu welchem Abstand vom Punkt seine Struktur zählt</translation>
    </message>
    <message numerus="yes">
        <source>%n views</source>
        <translation>
            <numerusform>%n Ansicht</numerusform>
            <numerusform>%n Ansichten</numerusform>
        </translation>
    </message>
    <message>
        <source>Finer near the best</source>
        <translation>Feiner nahe den besten</translation>
    </message>
    <message>
        <source>From how many sides the focus is looked at, evenly all around (12·n² HEALPix directions), or ever finer around the best ones</source>
        <translation>Von wie vielen Seiten der Fokus betrachtet wird, gleichmäßig ringsum (12·n² HEALPix-Richtungen), oder immer feiner um die besten</translation>
    </message>
    <message>
        <source>To its right</source>
        <translation>Rechts davon</translation>
    </message>
    <message>
        <source>All around</source>
        <translation>Ringsum</translation>
    </message>
    <message>
        <source>Where the second view may be, always 60° to 120° from the first.
To its right: the half sphere c2·a ≥ 0 around the first view&apos;s right axis a. All around: the band |c1·c2| ≤ sin δ</source>
        <translation>Wo die zweite Ansicht sein darf, immer 60° bis 120° von der ersten.
Rechts davon: die Halbkugel c2·a ≥ 0 um die rechte Achse a der ersten Ansicht. Ringsum: das Band |c1·c2| ≤ sin δ</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>δ: how far the second view may leave the right angle to the first</source>
        <translation>δ: wie weit die zweite Ansicht vom rechten Winkel zur ersten abweichen darf</translation>
    </message>
    <message>
        <source>Choose the two views that together see most of the focus&apos;s surface.
Off: first the best view, then the best one beside it</source>
        <translation>Wählt die zwei Ansichten, die zusammen am meisten von der Oberfläche des Fokus sehen.
Aus: erst die beste Ansicht, dann die beste daneben</translation>
    </message>
    <message>
        <source>What two views are chosen by: w · share of the surface seen + (1 − w) · mean quality of the views</source>
        <translation>Wonach zwei Ansichten gewählt werden: w · Anteil der gesehenen Oberfläche + (1 − w) · mittlere Güte der Ansichten</translation>
    </message>
    <message>
        <source>When the first view is turned, the second goes to the best view beside it</source>
        <translation>Wird die erste Ansicht gedreht, geht die zweite zur besten Ansicht daneben</translation>
    </message>
    <message>
        <source>Cameras for</source>
        <translation>Kameras für</translation>
    </message>
    <message>
        <source>Sides tried</source>
        <translation>Geprüfte Seiten</translation>
    </message>
    <message>
        <source>Second view</source>
        <translation>Zweite Ansicht</translation>
    </message>
    <message>
        <source>Off right angle</source>
        <translation>Vom rechten Winkel</translation>
    </message>
    <message>
        <source>Surface seen</source>
        <translation>Gesehene Oberfläche</translation>
    </message>
    <message>
        <source>More weights</source>
        <translation>Weitere Gewichte</translation>
    </message>
    <message>
        <source>Reach</source>
        <translation>Reichweite</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::PresetPicker</name>
    <message>
        <source>Presets</source>
        <translation>Vorgaben</translation>
    </message>
    <message>
        <source>Name of the preset</source>
        <translation>Name der Vorgabe</translation>
    </message>
    <message>
        <source>Import a preset</source>
        <translation>Vorgabe importieren</translation>
    </message>
    <message>
        <source>Presets (*.json)</source>
        <translation>Vorgaben (*.json)</translation>
    </message>
    <message>
        <source>Export the preset</source>
        <translation>Vorgabe exportieren</translation>
    </message>
    <message>
        <source>There is a preset &quot;%1&quot;. Replace it?</source>
        <translation>Es gibt eine Vorgabe „%1“. Ersetzen?</translation>
    </message>
    <message>
        <source>Delete the preset &quot;%1&quot;?</source>
        <translation>Vorgabe „%1“ löschen?</translation>
    </message>
    <message>
        <source>Open a transfer function</source>
        <translation>Transferfunktion öffnen</translation>
    </message>
    <message>
        <source>Transfer functions (*.json)</source>
        <translation>Transferfunktionen (*.json)</translation>
    </message>
    <message>
        <source>Edited</source>
        <translation>Bearbeitet</translation>
    </message>
    <message>
        <source>Transfer functions, and your own presets of the whole look</source>
        <translation>Transferfunktionen, und eigene Vorgaben des ganzen Aussehens</translation>
    </message>
    <message>
        <source>Keep, import, export, rename and delete presets</source>
        <translation>Vorgaben behalten, importieren, exportieren, umbenennen und löschen</translation>
    </message>
    <message>
        <source>From a file…</source>
        <translation>Aus einer Datei…</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Vorgabe</translation>
    </message>
    <message>
        <source>Keep this look as a preset…</source>
        <translation>Dieses Aussehen als Vorgabe behalten…</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>Umbenennen…</translation>
    </message>
    <message>
        <source>Delete…</source>
        <translation>Löschen…</translation>
    </message>
    <message>
        <source>Import a preset…</source>
        <translation>Vorgabe importieren…</translation>
    </message>
    <message>
        <source>Export this look…</source>
        <translation>Dieses Aussehen exportieren…</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>Aussehen</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::ReformatPanel</name>
    <message>
        <source>Dra&amp;w</source>
        <translation>&amp;Zeichnen</translation>
    </message>
    <message>
        <source>Follow the f&amp;ocus</source>
        <translation>F&amp;okus folgen</translation>
    </message>
    <message>
        <source>De&amp;lete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Click points on the slices; Backspace takes the last away, Enter or a double click ends the path</source>
        <translation>Klicken Sie Punkte auf den Schichten an; die Rücktaste nimmt den letzten weg, Eingabe oder ein Doppelklick beendet den Pfad</translation>
    </message>
    <message>
        <source>Finds the centre line of the tubular structure in focus</source>
        <translation>Findet die Mittellinie der röhrenförmigen Struktur im Fokus</translation>
    </message>
    <message>
        <source>Deletes the path</source>
        <translation>Löscht den Pfad</translation>
    </message>
    <message>
        <source>Width of the pictures</source>
        <translation>Breite der Bilder</translation>
    </message>
    <message>
        <source>Turns the straightened picture about the path</source>
        <translation>Dreht das gestreckte Bild um den Pfad</translation>
    </message>
    <message>
        <source>Straightened along the path</source>
        <translation>Gestreckt entlang des Pfades</translation>
    </message>
    <message>
        <source>Across the path</source>
        <translation>Quer zum Pfad</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Turned by</source>
        <translation>Gedreht um</translation>
    </message>
    <message>
        <source>Delete the path</source>
        <translation>Pfad löschen</translation>
    </message>
    <message>
        <source>Bring a label or a region into focus first: a vessel, or another tube.</source>
        <translation>Nehmen Sie zuerst ein Label oder eine Region in den Fokus: ein Gefäß oder eine andere Röhre.</translation>
    </message>
    <message>
        <source>Path along the focus</source>
        <translation>Pfad durch den Fokus</translation>
    </message>
    <message>
        <source>The structure in focus is no tube: it is hardly longer than thick. Draw a path instead.</source>
        <translation>Die Struktur im Fokus ist keine Röhre: sie ist kaum länger als dick. Zeichnen Sie stattdessen einen Pfad.</translation>
    </message>
    <message numerus="yes">
        <source>%n points; Enter ends the path</source>
        <translation>
            <numerusform>%n Punkt; Eingabe beendet den Pfad</numerusform>
            <numerusform>%n Punkte; Eingabe beendet den Pfad</numerusform>
        </translation>
    </message>
    <message>
        <source>Finding the centre line…</source>
        <translation>Mittellinie wird gesucht…</translation>
    </message>
    <message>
        <source>Draw a path on the slices, or follow the vessel that is in focus.</source>
        <translation>Zeichnen Sie einen Pfad auf den Schichten, oder folgen Sie dem Gefäß im Fokus.</translation>
    </message>
    <message>
        <source>At %1 of %2 mm</source>
        <translation>Bei %1 von %2 mm</translation>
    </message>
    <message>
        <source>Area %1 mm²</source>
        <translation>Fläche %1 mm²</translation>
    </message>
    <message>
        <source>Radius %1 mm</source>
        <translation>Radius %1 mm</translation>
    </message>
    <message>
        <source>Reading the structure in focus…</source>
        <translation>Struktur im Fokus wird gelesen…</translation>
    </message>
    <message>
        <source>No structure in focus here: no area</source>
        <translation>Keine Struktur im Fokus hier: keine Fläche</translation>
    </message>
    <message>
        <source>Cameras follow</source>
        <translation>Kameras folgen</translation>
    </message>
    <message>
        <source>Both cameras keep the place on the path in the middle of their pictures as you move along it</source>
        <translation>Beide Kameras halten die Stelle des Pfades in der Mitte ihrer Bilder, während Sie ihn entlanggehen</translation>
    </message>
    <message>
        <source>Open along the path</source>
        <translation>Entlang des Pfads öffnen</translation>
    </message>
    <message>
        <source>The view opens to a tube around the path, which goes along when the path changes</source>
        <translation>Die Ansicht öffnet sich bis zu einer Röhre um den Pfad, die mitgeht, wenn er sich ändert</translation>
    </message>
    <message>
        <source>Radius of the tube that the view opens to</source>
        <translation>Radius der Röhre, bis zu der sich die Ansicht öffnet</translation>
    </message>
    <message>
        <source>The tube around the path is in focus: untick Open along the path, and bring a vessel into focus.</source>
        <translation>Die Röhre um den Pfad ist im Fokus: Schalten Sie „Entlang des Pfads öffnen“ aus, und bringen Sie ein Gefäß in den Fokus.</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::RegionGrower</name>
    <message>
        <source>No region grows from there; click elsewhere.</source>
        <translation>Von dort wächst keine Region; klicken Sie woanders.</translation>
    </message>
    <message>
        <source>Nothing would be left of the region; it stays as it was.</source>
        <translation>Von der Region bliebe nichts; sie bleibt, wie sie war.</translation>
    </message>
    <message>
        <source>That is air, which fills more than half of the volume; click a structure.</source>
        <translation>Das ist Luft, die mehr als die Hälfte des Volumens füllt; klicken Sie eine Struktur an.</translation>
    </message>
    <message>
        <source>No border holds the region there: it would fill more than half of the volume. Drag a ball around the structure (Shift+drag), or click elsewhere.</source>
        <translation>Keine Grenze hält die Region dort: sie füllte mehr als die Hälfte des Volumens. Ziehen Sie eine Kugel um die Struktur (Umschalt+Ziehen), oder klicken Sie woanders.</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::RegionPanel</name>
    <message>
        <source>Open the 3-D views to it</source>
        <translation>3-D-Ansichten dazu öffnen</translation>
    </message>
    <message>
        <source>Colour of the label</source>
        <translation>Farbe des Labels</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Behalten</translation>
    </message>
    <message>
        <source>Shift+click adds to the region, Ctrl+click takes away. Shift+drag draws a ball around a structure, which its region does not leave.</source>
        <translation>Umschalt+Klick fügt zur Region hinzu, Strg+Klick nimmt weg. Umschalt+Ziehen zieht eine Kugel um eine Struktur, die deren Region nicht verlässt.</translation>
    </message>
    <message>
        <source>How far values may lie from those at the click (Alt+wheel over a picture, keys , and .)</source>
        <translation>Wie weit Werte von denen beim Klick abweichen dürfen (Alt+Rad über einem Bild, Tasten , und .)</translation>
    </message>
    <message>
        <source>Tolerance: how far values may lie below those at the click</source>
        <translation>Toleranz: wie weit Werte unter denen beim Klick liegen dürfen</translation>
    </message>
    <message>
        <source>Auto</source>
        <translation>Auto</translation>
    </message>
    <message>
        <source>The tolerance is chosen from the plateaus</source>
        <translation>Die Toleranz wird aus den Plateaus gewählt</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Radius of the ball around the click, which the region does not leave</source>
        <translation>Radius der Kugel um den Klick, die die Region nicht verlässt</translation>
    </message>
    <message>
        <source>No ball</source>
        <translation>Keine Kugel</translation>
    </message>
    <message>
        <source>Nothing bounds the region</source>
        <translation>Nichts begrenzt die Region</translation>
    </message>
    <message>
        <source>Within a ball of</source>
        <translation>In einer Kugel von</translation>
    </message>
    <message>
        <source>Name of a label</source>
        <translation>Name eines Labels</translation>
    </message>
    <message>
        <source>Keep the region as a label of this study</source>
        <translation>Die Region als Label dieser Studie behalten</translation>
    </message>
    <message>
        <source>Region: growing…</source>
        <translation>Region: wächst…</translation>
    </message>
    <message>
        <source>That is %1 % of the body: the 3-D views do not open to it by themselves.</source>
        <translation>Das sind %1 % des Körpers: die 3-D-Ansichten öffnen sich nicht von selbst dazu.</translation>
    </message>
    <message>
        <source>The 3-D views do not open to it by themselves.</source>
        <translation>Die 3-D-Ansichten öffnen sich nicht von selbst dazu.</translation>
    </message>
    <message>
        <source>Region: %1</source>
        <translation>Region: %1</translation>
    </message>
    <message>
        <source>Region: %1 so far…</source>
        <translation>Region: bisher %1…</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::ResultsDialog</name>
    <message>
        <source>Save results</source>
        <translation>Ergebnisse speichern</translation>
    </message>
    <message>
        <source>Writing…</source>
        <translation>Schreibt…</translation>
    </message>
    <message>
        <source>Stopped. Nothing was written; an archive keeps what it had taken.</source>
        <translation>Angehalten. Nichts wurde geschrieben; ein Archiv behält, was es schon angenommen hatte.</translation>
    </message>
    <message>
        <source>Measures and the table of labels, as a report</source>
        <translation>Messungen und die Tabelle der Labels, als Bericht</translation>
    </message>
    <message>
        <source>A structured report (TID 1500): distances, angles, areas and values of the measures, volume and values of each label, and the segmentation that these refer to</source>
        <translation>Ein strukturierter Bericht (TID 1500): Abstände, Winkel, Flächen und Werte der Messungen, Volumen und Werte jedes Labels und die Segmentierung, auf die sie sich beziehen</translation>
    </message>
    <message>
        <source>All labels, as a segmentation</source>
        <translation>Alle Labels, als Segmentierung</translation>
    </message>
    <message>
        <source>With their names and colours</source>
        <translation>Mit ihren Namen und Farben</translation>
    </message>
    <message>
        <source>The focus, as a segmentation</source>
        <translation>Der Fokus, als Segmentierung</translation>
    </message>
    <message>
        <source>Labels as they are; a region or a range of values as one segment</source>
        <translation>Labels, wie sie sind; eine Region oder ein Wertebereich als ein Segment</translation>
    </message>
    <message>
        <source>A picture of</source>
        <translation>Ein Bild von</translation>
    </message>
    <message>
        <source>A secondary capture, which says what makes the picture less than exact</source>
        <translation>Ein Secondary Capture, das sagt, was das Bild ungenau macht</translation>
    </message>
    <message>
        <source>Views in the picture</source>
        <translation>Ansichten im Bild</translation>
    </message>
    <message>
        <source>A key object selection, which names slices of the series</source>
        <translation>Eine Auswahl von Schlüsselobjekten, die Schichten der Serie nennt</translation>
    </message>
    <message>
        <source>by the kind of object</source>
        <translation>nach der Art des Objekts</translation>
    </message>
    <message>
        <source>Description of the series</source>
        <translation>Beschreibung der Serie</translation>
    </message>
    <message>
        <source>To the folder</source>
        <translation>In den Ordner</translation>
    </message>
    <message>
        <source>A file for each object</source>
        <translation>Eine Datei für jedes Objekt</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen…</translation>
    </message>
    <message>
        <source>To the archive</source>
        <translation>In das Archiv</translation>
    </message>
    <message>
        <source>The server answers for each object</source>
        <translation>Der Server antwortet zu jedem Objekt</translation>
    </message>
    <message>
        <source>Server</source>
        <translation>Server</translation>
    </message>
    <message>
        <source>The objects hold the patient&apos;s name and ID, also while the window hides them: archives and other programs file them by these.</source>
        <translation>Die Objekte enthalten Name und ID des Patienten, auch während das Fenster sie verbirgt: Archive und andere Programme ordnen sie danach ein.</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Folder of the results</source>
        <translation>Ordner der Ergebnisse</translation>
    </message>
    <message>
        <source>This study is not from DICOM files, so there is no DICOM study that this could belong to.</source>
        <translation>Diese Studie stammt nicht aus DICOM-Dateien, also gibt es keine DICOM-Studie, zu der dies gehören könnte.</translation>
    </message>
    <message>
        <source>Nothing is in focus.</source>
        <translation>Nichts ist im Fokus.</translation>
    </message>
    <message>
        <source>The region in focus is not complete yet.</source>
        <translation>Die Region im Fokus ist noch nicht vollständig.</translation>
    </message>
    <message>
        <source>This series was read from an archive file. Unpack it and open the folder.</source>
        <translation>Diese Serie wurde aus einer Archivdatei gelesen. Entpacken Sie sie und öffnen Sie den Ordner.</translation>
    </message>
    <message>
        <source>The slices of this series do not lie evenly: what is shown is interpolated between them.</source>
        <translation>Die Schichten dieser Serie liegen nicht gleichmäßig: Das Gezeigte ist zwischen ihnen interpoliert.</translation>
    </message>
    <message>
        <source>There are no key images (View → Keep a key image).</source>
        <translation>Es gibt keine Schlüsselbilder (Ansicht → Schlüsselbild behalten).</translation>
    </message>
    <message>
        <source>The crosshair of no key image lies in the volume.</source>
        <translation>Bei keinem Schlüsselbild liegt das Fadenkreuz im Volumen.</translation>
    </message>
    <message>
        <source>There are neither measures nor labels.</source>
        <translation>Es gibt weder Messungen noch Labels.</translation>
    </message>
    <message>
        <source>There are no labels.</source>
        <translation>Es gibt keine Labels.</translation>
    </message>
    <message>
        <source>No view is on screen.</source>
        <translation>Keine Ansicht ist zu sehen.</translation>
    </message>
    <message>
        <source>Slices of the key images: %1</source>
        <translation>Schichten der Schlüsselbilder: %1</translation>
    </message>
    <message>
        <source>Slices of the key images</source>
        <translation>Schichten der Schlüsselbilder</translation>
    </message>
    <message>
        <source>This study is not from DICOM files, and archives file by patient and study.</source>
        <translation>Diese Studie stammt nicht aus DICOM-Dateien, und Archive ordnen nach Patient und Studie.</translation>
    </message>
    <message>
        <source>No server is entered yet (View → Archive).</source>
        <translation>Noch ist kein Server eingetragen (Ansicht → Archiv).</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Region</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>Values %1 to %2 %3</source>
        <translation>Werte %1 bis %2 %3</translation>
    </message>
    <message>
        <source>Drawing the picture…</source>
        <translation>Das Bild wird gezeichnet…</translation>
    </message>
    <message>
        <source>Wrote %1.</source>
        <translation>%1 geschrieben.</translation>
    </message>
    <message>
        <source>Nothing was sent: %1</source>
        <translation>Nichts wurde gesendet: %1</translation>
    </message>
    <message>
        <source>Ask the archive to confirm that it keeps them</source>
        <translation>Das Archiv bestätigen lassen, dass es sie aufbewahrt</translation>
    </message>
    <message>
        <source>DICOMweb has no such confirmation</source>
        <translation>DICOMweb hat keine solche Bestätigung</translation>
    </message>
    <message>
        <source>A storage commitment: the archive says of each object whether it is stored safely. Most connect to our address and port for that, which are open meanwhile</source>
        <translation>Eine Speicherzusage (Storage Commitment): Das Archiv sagt von jedem Objekt, ob es sicher gespeichert ist. Die meisten verbinden sich dazu mit unserer Adresse und unserem Port, die währenddessen offen sind</translation>
    </message>
    <message>
        <source>None is confirmed to be kept: %1</source>
        <translation>Von keinem ist bestätigt, dass es aufbewahrt wird: %1</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::RetrievalRow</name>
    <message>
        <source>Pause</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Fortsetzen</translation>
    </message>
    <message>
        <source>Retry</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Waits for others</source>
        <translation>Wartet auf andere</translation>
    </message>
    <message>
        <source>Stops…</source>
        <translation>Hält an…</translation>
    </message>
    <message>
        <source>Paused; what came is kept</source>
        <translation>Angehalten; was ankam, bleibt</translation>
    </message>
    <message>
        <source>Whole</source>
        <translation>Vollständig</translation>
    </message>
    <message>
        <source>Cancels it, and takes it out of the list. What came stays in the cache</source>
        <translation>Bricht ab und nimmt den Abruf aus der Liste. Was ankam, bleibt im Zwischenspeicher</translation>
    </message>
    <message>
        <source>Retrieval %1</source>
        <translation>Abruf %1</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::Retrievals</name>
    <message>
        <source>The server needs a login.</source>
        <translation>Der Server verlangt eine Anmeldung.</translation>
    </message>
    <message>
        <source>Its server is no longer in the list.</source>
        <translation>Der Server steht nicht mehr in der Liste.</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::SearchForm</name>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Asks the server for the studies that match. Empty fields match all (Return)</source>
        <translation>Fragt den Server nach passenden Studien. Leere Felder passen auf alle (Eingabe)</translation>
    </message>
    <message>
        <source>Saved searches</source>
        <translation>Gespeicherte Suchen</translation>
    </message>
    <message>
        <source>Searches under a name. A patient&apos;s name, ID and accession number are not saved</source>
        <translation>Suchen unter einem Namen. Name, ID und Accession-Nummer eines Patienten werden nicht gespeichert</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>ID</source>
        <translation>ID</translation>
    </message>
    <message>
        <source>Accession</source>
        <translation>Accession</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Typ</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>Beschreibung</translation>
    </message>
    <message>
        <source>An asterisk stands for any text, a question mark for one character</source>
        <translation>Ein Stern steht für beliebigen Text, ein Fragezeichen für ein Zeichen</translation>
    </message>
    <message>
        <source>Family name, or &quot;Doe, Jane&quot;: all names that begin so. %1, as in *jane*</source>
        <translation>Familienname, oder „Doe, Jane“: alle Namen, die so beginnen. %1, wie in *jane*</translation>
    </message>
    <message>
        <source>The patient&apos;s ID as it is. %1, as in 47*</source>
        <translation>Die ID des Patienten, wie sie ist. %1, wie in 47*</translation>
    </message>
    <message>
        <source>The accession number as it is. %1, as in A2024*</source>
        <translation>Die Accession-Nummer, wie sie ist. %1, wie in A2024*</translation>
    </message>
    <message>
        <source>All descriptions of studies that hold this text. %1, as in head*</source>
        <translation>Alle Beschreibungen von Studien mit diesem Text. %1, wie in head*</translation>
    </message>
    <message>
        <source>The kind of images that the study holds</source>
        <translation>Die Art der Bilder, die die Studie enthält</translation>
    </message>
    <message>
        <source>Any</source>
        <translation>Beliebig</translation>
    </message>
    <message>
        <source>When the study was made</source>
        <translation>Wann die Studie gemacht wurde</translation>
    </message>
    <message>
        <source>Today</source>
        <translation>Heute</translation>
    </message>
    <message>
        <source>Last 7 days</source>
        <translation>Letzte 7 Tage</translation>
    </message>
    <message>
        <source>Last 30 days</source>
        <translation>Letzte 30 Tage</translation>
    </message>
    <message>
        <source>Last 365 days</source>
        <translation>Letzte 365 Tage</translation>
    </message>
    <message>
        <source>From … to</source>
        <translation>Von … bis</translation>
    </message>
    <message>
        <source>First day</source>
        <translation>Erster Tag</translation>
    </message>
    <message>
        <source>Last day</source>
        <translation>Letzter Tag</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Save this search…</source>
        <translation>Diese Suche speichern…</translation>
    </message>
    <message>
        <source>Save this search</source>
        <translation>Diese Suche speichern</translation>
    </message>
    <message>
        <source>Its name (date, type and description are saved, nothing of a patient):</source>
        <translation>Ihr Name (gespeichert werden Datum, Typ und Beschreibung, nichts von einem Patienten):</translation>
    </message>
    <message>
        <source>Forget</source>
        <translation>Vergessen</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::SendDialog</name>
    <message>
        <source>Nothing is open.</source>
        <translation>Es ist nichts geöffnet.</translation>
    </message>
    <message>
        <source>What is open is not DICOM, and archives keep nothing else.</source>
        <translation>Das Geöffnete ist kein DICOM, und Archive bewahren nichts anderes auf.</translation>
    </message>
    <message>
        <source>Send to an archive</source>
        <translation>An ein Archiv senden</translation>
    </message>
    <message>
        <source>Send</source>
        <translation>Senden</translation>
    </message>
    <message>
        <source>The server that gets the objects</source>
        <translation>Der Server, der die Objekte bekommt</translation>
    </message>
    <message>
        <source>The open series, images: %1</source>
        <translation>Die geöffnete Serie, Bilder: %1</translation>
    </message>
    <message>
        <source>Its files as they are</source>
        <translation>Ihre Dateien, wie sie sind</translation>
    </message>
    <message>
        <source>All labels, as a DICOM segmentation</source>
        <translation>Alle Labels, als DICOM-Segmentierung</translation>
    </message>
    <message>
        <source>With their names and colours, for the patient and the series that are open</source>
        <translation>Mit ihren Namen und Farben, für den Patienten und die Serie, die geöffnet sind</translation>
    </message>
    <message>
        <source>The objects hold the patient&apos;s name and ID: an archive files them by these.</source>
        <translation>Die Objekte enthalten Name und ID des Patienten: Ein Archiv ordnet sie danach ein.</translation>
    </message>
    <message>
        <source>Server</source>
        <translation>Server</translation>
    </message>
    <message>
        <source>Image %1</source>
        <translation>Bild %1</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>Labels</translation>
    </message>
    <message>
        <source>Ask the archive to confirm that it keeps them</source>
        <translation>Das Archiv bestätigen lassen, dass es sie aufbewahrt</translation>
    </message>
    <message>
        <source>DICOMweb has no such confirmation</source>
        <translation>DICOMweb hat keine solche Bestätigung</translation>
    </message>
    <message>
        <source>A storage commitment: the archive says of each object whether it is stored safely. Most connect to our address and port for that, which are open meanwhile</source>
        <translation>Eine Speicherzusage (Storage Commitment): Das Archiv sagt von jedem Objekt, ob es sicher gespeichert ist. Die meisten verbinden sich dazu mit unserer Adresse und unserem Port, die währenddessen offen sind</translation>
    </message>
    <message>
        <source>None is confirmed to be kept: %1</source>
        <translation>Von keinem ist bestätigt, dass es aufbewahrt wird: %1</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::SentAnswers</name>
    <message>
        <source>Object</source>
        <translation>Objekt</translation>
    </message>
    <message>
        <source>Answer of the server</source>
        <translation>Antwort des Servers</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>angenommen</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>abgelehnt</translation>
    </message>
    <message>
        <source>Accepted: %1 of %2.</source>
        <translation>Angenommen: %1 von %2.</translation>
    </message>
    <message>
        <source>kept</source>
        <translation>aufbewahrt</translation>
    </message>
    <message>
        <source>not kept: %1</source>
        <translation>nicht aufbewahrt: %1</translation>
    </message>
    <message>
        <source>not confirmed to be kept</source>
        <translation>Aufbewahrung nicht bestätigt</translation>
    </message>
    <message>
        <source>Confirmed to be kept: %1 of %2.</source>
        <translation>Aufbewahrung bestätigt: %1 von %2.</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::SeriesPanel</name>
    <message>
        <source>Series</source>
        <translation>Serien</translation>
    </message>
    <message>
        <source>Patient %1</source>
        <translation>Patient %1</translation>
    </message>
    <message>
        <source>Patient without a name</source>
        <translation>Patient ohne Namen</translation>
    </message>
    <message>
        <source>1 image</source>
        <translation>1 Bild</translation>
    </message>
    <message numerus="yes">
        <source>%n images</source>
        <translation>
            <numerusform>%n Bild</numerusform>
            <numerusform>%n Bilder</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, open</source>
        <translation>%1, geöffnet</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Open beside</source>
        <translation>Daneben öffnen</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::ServerDialog</name>
    <message>
        <source>Archive server</source>
        <translation>Archivserver</translation>
    </message>
    <message>
        <source>As you call it</source>
        <translation>Wie Sie ihn nennen</translation>
    </message>
    <message>
        <source>DICOM</source>
        <translation>DICOM</translation>
    </message>
    <message>
        <source>DICOM over TLS</source>
        <translation>DICOM über TLS</translation>
    </message>
    <message>
        <source>DICOMweb</source>
        <translation>DICOMweb</translation>
    </message>
    <message>
        <source>What the server speaks; its administrator knows</source>
        <translation>Was der Server spricht; sein Administrator weiß es</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Speaks</source>
        <translation>Spricht</translation>
    </message>
    <message>
        <source>Its name or address in the network</source>
        <translation>Sein Name oder seine Adresse im Netz</translation>
    </message>
    <message>
        <source>The port that it listens on</source>
        <translation>Der Port, auf dem er lauscht</translation>
    </message>
    <message>
        <source>Its AE title, at most 16 letters and digits</source>
        <translation>Sein AE-Titel, höchstens 16 Buchstaben und Ziffern</translation>
    </message>
    <message>
        <source>Our AE title: its administrator enters it at the server</source>
        <translation>Der eigene AE-Titel: Der Administrator trägt ihn beim Server ein</translation>
    </message>
    <message>
        <source>C-GET, over our connection</source>
        <translation>C-GET, über unsere Verbindung</translation>
    </message>
    <message>
        <source>C-MOVE, the server connects to us</source>
        <translation>C-MOVE, der Server verbindet sich mit uns</translation>
    </message>
    <message>
        <source>How objects come. C-GET needs nothing more; with C-MOVE our address and port are entered at the server, and the port is open while objects come</source>
        <translation>Wie Objekte kommen. C-GET braucht nichts weiter; bei C-MOVE sind eigene Adresse und eigener Port beim Server eingetragen, und der Port ist offen, solange Objekte kommen</translation>
    </message>
    <message>
        <source>Host</source>
        <translation>Host</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Port</translation>
    </message>
    <message>
        <source>Its AE title</source>
        <translation>Sein AE-Titel</translation>
    </message>
    <message>
        <source>Our AE title</source>
        <translation>Eigener AE-Titel</translation>
    </message>
    <message>
        <source>Retrieve by</source>
        <translation>Abrufen mit</translation>
    </message>
    <message>
        <source>Our address</source>
        <translation>Eigene Adresse</translation>
    </message>
    <message>
        <source>Our port</source>
        <translation>Eigener Port</translation>
    </message>
    <message>
        <source>The address of DICOMweb&apos;s root. A login goes out over https alone</source>
        <translation>Die Adresse der DICOMweb-Wurzel. Eine Anmeldung geht nur über https hinaus</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>User and password</source>
        <translation>Benutzer und Passwort</translation>
    </message>
    <message>
        <source>Token</source>
        <translation>Token</translation>
    </message>
    <message>
        <source>Who you are to the server</source>
        <translation>Wer Sie für den Server sind</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>Login</source>
        <translation>Anmeldung</translation>
    </message>
    <message>
        <source>User</source>
        <translation>Benutzer</translation>
    </message>
    <message>
        <source>Certificates that may sign the server&apos;s</source>
        <translation>Zertifikate, die das des Servers signieren dürfen</translation>
    </message>
    <message>
        <source>Certificates in PEM that may sign the server&apos;s, or its own</source>
        <translation>Zertifikate in PEM, die das des Servers signieren dürfen, oder sein eigenes</translation>
    </message>
    <message>
        <source>Our certificate</source>
        <translation>Eigenes Zertifikat</translation>
    </message>
    <message>
        <source>In PEM, where the server asks for one</source>
        <translation>In PEM, wenn der Server eines verlangt</translation>
    </message>
    <message>
        <source>The key of our certificate</source>
        <translation>Der Schlüssel des eigenen Zertifikats</translation>
    </message>
    <message>
        <source>In PEM, without a passphrase</source>
        <translation>In PEM, ohne Passphrase</translation>
    </message>
    <message>
        <source>Trusted certificates</source>
        <translation>Vertraute Zertifikate</translation>
    </message>
    <message>
        <source>Its key</source>
        <translation>Dessen Schlüssel</translation>
    </message>
    <message>
        <source>Choose the file</source>
        <translation>Die Datei wählen</translation>
    </message>
    <message>
        <source>Certificates and keys (*.pem *.crt *.cer *.key);;All files (*)</source>
        <translation>Zertifikate und Schlüssel (*.pem *.crt *.cer *.key);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Token for %1:</source>
        <translation>Token für %1:</translation>
    </message>
    <message>
        <source>Password of %1 for %2:</source>
        <translation>Passwort von %1 für %2:</translation>
    </message>
    <message>
        <source>Address of this machine that the server sends to: objects by C-MOVE, and whether it keeps what it was sent</source>
        <translation>Adresse dieses Rechners, an die der Server sendet: Objekte mit C-MOVE, und ob er aufbewahrt, was ihm gesendet wurde</translation>
    </message>
    <message>
        <source>Port of this machine that the server sends to; it is open while that is waited for</source>
        <translation>Port dieses Rechners, an den der Server sendet; er ist offen, solange darauf gewartet wird</translation>
    </message>
    <message>
        <source>The password or token is asked for when it is needed</source>
        <translation>Nach Passwort oder Token wird gefragt, wenn es gebraucht wird</translation>
    </message>
    <message>
        <source>Keep the password or token in the key ring</source>
        <translation>Passwort oder Token im Schlüsselbund aufbewahren</translation>
    </message>
    <message>
        <source>The password or token is kept where the desktop keeps those of other programs, encrypted, and nowhere else. Otherwise it is forgotten when the program ends</source>
        <translation>Passwort oder Token wird dort aufbewahrt, wo der Desktop die anderer Programme aufbewahrt, verschlüsselt, und nirgends sonst. Andernfalls wird es vergessen, wenn das Programm endet</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::Sessions</name>
    <message>
        <source>Sessions</source>
        <translation>Sitzungen</translation>
    </message>
    <message>
        <source>Unsaved work</source>
        <translation>Ungespeicherte Arbeit</translation>
    </message>
    <message>
        <source>These changes since the last save would be lost. Save them?</source>
        <translation>Diese Änderungen seit dem letzten Speichern gingen verloren. Speichern?</translation>
    </message>
    <message>
        <source>Where is the data now?</source>
        <translation>Wo sind die Daten jetzt?</translation>
    </message>
    <message>
        <source>The session&apos;s label map is needed.</source>
        <translation>Die Labelkarte der Sitzung wird gebraucht.</translation>
    </message>
    <message>
        <source>The session&apos;s volume is needed.</source>
        <translation>Das Volumen der Sitzung wird gebraucht.</translation>
    </message>
    <message>
        <source>Choose a file…</source>
        <translation>Datei wählen…</translation>
    </message>
    <message>
        <source>Choose a folder…</source>
        <translation>Ordner wählen…</translation>
    </message>
    <message>
        <source>The data</source>
        <translation>Die Daten</translation>
    </message>
    <message>
        <source>The data&apos;s folder</source>
        <translation>Der Ordner der Daten</translation>
    </message>
    <message>
        <source>%1 %2. Say it here:</source>
        <translation>%1 %2. Geben Sie sie hier an:</translation>
    </message>
    <message>
        <source>Fenestra ended before the session was saved. A copy from %1 can be restored.</source>
        <translation>Fenestra endete, bevor die Sitzung gespeichert war. Eine Kopie vom %1 lässt sich wiederherstellen.</translation>
    </message>
    <message>
        <source>Fenestra ended before the work on %1 was saved. A copy from %2 can be restored.</source>
        <translation>Fenestra endete, bevor die Arbeit an %1 gespeichert war. Eine Kopie vom %2 lässt sich wiederherstellen.</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Ask later</source>
        <translation>Später fragen</translation>
    </message>
    <message numerus="yes">
        <source>%n more</source>
        <translation>
            <numerusform>%n weitere</numerusform>
            <numerusform>%n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>Save the session</source>
        <translation>Sitzung speichern</translation>
    </message>
    <message>
        <source>Open a session</source>
        <translation>Sitzung öffnen</translation>
    </message>
    <message>
        <source>The labels that you kept are in no file yet, and reading the data again would drop them. Save the session first.</source>
        <translation>Die behaltenen Labels sind noch in keiner Datei, und neues Lesen der Daten ließe sie fallen. Speichern Sie zuerst die Sitzung.</translation>
    </message>
    <message>
        <source>The restored work</source>
        <translation>Die wiederhergestellte Arbeit</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::SettingsDialog</name>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::SliceView</name>
    <message>
        <source>Not yet as asked for</source>
        <translation>Noch nicht das Verlangte</translation>
    </message>
    <message>
        <source>Interpolated, not scanned</source>
        <translation>Interpoliert, nicht aufgenommen</translation>
    </message>
    <message>
        <source>%1 / %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Radiological</source>
        <translation>Radiologisch</translation>
    </message>
    <message>
        <source>L %1</source>
        <translation>Z %L1</translation>
    </message>
    <message>
        <source>W %1</source>
        <translation>B %L1</translation>
    </message>
    <message>
        <source>inverted</source>
        <translation>invertiert</translation>
    </message>
    <message>
        <source>Oblique, %1° from %2</source>
        <translation>Schräg, %1° von %2</translation>
    </message>
    <message>
        <source>Faces C1, %1° from %2</source>
        <translation>Zu C1, %1° von %2</translation>
    </message>
    <message>
        <source>Faces C2, %1° from %2</source>
        <translation>Zu C2, %1° von %2</translation>
    </message>
    <message>
        <source>Neurological</source>
        <translation>Neurologisch</translation>
    </message>
    <message>
        <source>flipped</source>
        <translation>gespiegelt</translation>
    </message>
    <message>
        <source>turned by %1°</source>
        <translation>um %1° gedreht</translation>
    </message>
    <message>
        <source>true size</source>
        <translation>wahre Größe</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::SpacingDialog</name>
    <message>
        <source>Size of the voxels</source>
        <translation>Voxelgröße</translation>
    </message>
    <message>
        <source>&amp;Across a row</source>
        <translation>&amp;Entlang einer Zeile</translation>
    </message>
    <message>
        <source>&amp;Down a column</source>
        <translation>Entlang einer &amp;Spalte</translation>
    </message>
    <message>
        <source>From &amp;slice to slice</source>
        <translation>&amp;Von Schicht zu Schicht</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>not said</source>
        <translation>nicht angegeben</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::SphereMap</name>
    <message>
        <source>How good each viewpoint is, from dark to bright; click to look from there</source>
        <translation>Wie gut jeder Blickpunkt ist, von dunkel bis hell; Klick: von dort sehen</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::StatusBar</name>
    <message>
        <source>Software OpenGL</source>
        <translation>Software-OpenGL</translation>
    </message>
    <message>
        <source>Pictures are smaller while something moves: %1 draws them</source>
        <translation>Bilder sind kleiner, solange sich etwas bewegt: %1 zeichnet sie</translation>
    </message>
    <message>
        <source>No OpenGL: slices only</source>
        <translation>Kein OpenGL: nur Schichten</translation>
    </message>
    <message>
        <source>Time until the last picture was on screen, and its sampling</source>
        <translation>Zeit, bis das letzte Bild zu sehen war, und seine Abtastung</translation>
    </message>
    <message>
        <source>Radiological convention</source>
        <translation>Radiologische Konvention</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%L1 ms</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%L1 s</translation>
    </message>
    <message>
        <source>, %1 % size</source>
        <translation>, %1 % Größe</translation>
    </message>
    <message>
        <source>Neurological convention</source>
        <translation>Neurologische Konvention</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::StrokeList</name>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Clear all</source>
        <translation>Alle löschen</translation>
    </message>
    <message>
        <source>Load…</source>
        <translation>Laden…</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Speichern…</translation>
    </message>
    <message>
        <source>Tick the strokes to apply</source>
        <translation>Angehakte Striche gelten</translation>
    </message>
    <message>
        <source>Adds the strokes of a file</source>
        <translation>Fügt die Striche einer Datei hinzu</translation>
    </message>
    <message>
        <source>Clear strokes</source>
        <translation>Striche löschen</translation>
    </message>
    <message>
        <source>Load brush strokes</source>
        <translation>Pinselstriche laden</translation>
    </message>
    <message>
        <source>Brush strokes (*.json)</source>
        <translation>Pinselstriche (*.json)</translation>
    </message>
    <message>
        <source>Brush strokes</source>
        <translation>Pinselstriche</translation>
    </message>
    <message>
        <source>Save brush strokes</source>
        <translation>Pinselstriche speichern</translation>
    </message>
    <message>
        <source>Delete stroke</source>
        <translation>Strich löschen</translation>
    </message>
    <message>
        <source>Delete strokes</source>
        <translation>Striche löschen</translation>
    </message>
    <message>
        <source>Load strokes</source>
        <translation>Striche laden</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::StrokeModel</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>to the surface</source>
        <translation>bis zur Oberfläche</translation>
    </message>
    <message>
        <source>%1 mm deep</source>
        <translation>%L1 mm tief</translation>
    </message>
    <message>
        <source>over the focus</source>
        <translation>über dem Fokus</translation>
    </message>
    <message>
        <source>C%1 only</source>
        <translation>nur C%1</translation>
    </message>
    <message>
        <source>Hide stroke</source>
        <translation>Strich verbergen</translation>
    </message>
    <message>
        <source>Show stroke</source>
        <translation>Strich anzeigen</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::StudyLinkBar</name>
    <message>
        <source>Link</source>
        <translation>Koppeln</translation>
    </message>
    <message>
        <source>The crosshair, scrolling, zoom and turning of one study go along with those of the other, by patient position</source>
        <translation>Fadenkreuz, Blättern, Zoom und Drehen einer Studie gehen mit denen der anderen mit, nach Patientenposition</translation>
    </message>
    <message>
        <source>Match points</source>
        <translation>Punkte zuordnen</translation>
    </message>
    <message>
        <source>The crosshairs of both studies mark the same point: link the studies by it</source>
        <translation>Die Fadenkreuze beider Studien bezeichnen denselben Punkt: die Studien danach koppeln</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>Forget the pair of points: the same coordinates are the same point</source>
        <translation>Das Punktepaar vergessen: gleiche Koordinaten sind derselbe Punkt</translation>
    </message>
    <message>
        <source>not linked</source>
        <translation>nicht gekoppelt</translation>
    </message>
    <message>
        <source>linked by patient position</source>
        <translation>nach Patientenposition gekoppelt</translation>
    </message>
    <message>
        <source>linked, offset %1, %2, %3 mm</source>
        <translation>gekoppelt, Versatz %1, %2, %3 mm</translation>
    </message>
    <message>
        <source>Offset of the other study to the patient&apos;s left, posterior and superior</source>
        <translation>Versatz der anderen Studie nach links, hinten und oben am Patienten</translation>
    </message>
    <message>
        <source>Left study</source>
        <translation>Linke Studie</translation>
    </message>
    <message>
        <source>Right study</source>
        <translation>Rechte Studie</translation>
    </message>
    <message>
        <source>%1, active</source>
        <translation>%1, aktiv</translation>
    </message>
    <message>
        <source>%1 mm apart, where a study ends</source>
        <translation>%1 mm auseinander, am Ende einer Studie</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::StudyNotices</name>
    <message numerus="yes">
        <source>There are %n time points here; this is number %1.</source>
        <translation>
            <numerusform>Hier ist %n Zeitpunkt; dies ist Nummer %1.</numerusform>
            <numerusform>Hier sind %n Zeitpunkte; dies ist Nummer %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>There are %n series here; open is %1.</source>
        <translation>
            <numerusform>Hier ist %n Serie; geöffnet ist %1.</numerusform>
            <numerusform>Hier sind %n Serien; geöffnet ist %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen…</translation>
    </message>
    <message>
        <source>A segmentation of this series lies beside it: %1.</source>
        <translation>Daneben liegt eine Segmentierung dieser Serie: %1.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message numerus="yes">
        <source>%n segmentations of this series lie beside it.</source>
        <translation>
            <numerusform>Daneben liegt %n Segmentierung dieser Serie.</numerusform>
            <numerusform>Daneben liegen %n Segmentierungen dieser Serie.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::TagsPanel</name>
    <message>
        <source>Search tags, names and values</source>
        <translation>Attribute, Namen und Werte suchen</translation>
    </message>
    <message>
        <source>DICOM tags</source>
        <translation>DICOM-Attribute</translation>
    </message>
    <message>
        <source>Tag</source>
        <translation>Tag</translation>
    </message>
    <message>
        <source>VR</source>
        <translation>VR</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>This study is no DICOM series: its format is %1, which has no DICOM tags.</source>
        <translation>Diese Studie ist keine DICOM-Serie: Ihr Format ist %1, das keine DICOM-Attribute hat.</translation>
    </message>
    <message>
        <source>This series was read from an archive. Unpack it and open the folder to see its tags.</source>
        <translation>Diese Serie wurde aus einem Archiv gelesen. Entpacken Sie es und öffnen Sie den Ordner, um die Attribute zu sehen.</translation>
    </message>
    <message>
        <source>The slices of this series do not lie evenly. What is shown is interpolated between them, and no file holds it.</source>
        <translation>Die Schichten dieser Serie liegen nicht gleichmäßig. Was gezeigt wird, ist zwischen ihnen interpoliert, und keine Datei enthält es.</translation>
    </message>
    <message>
        <source>This plane is turned and crosses several files. Reset it (View → Slices), or click another view.</source>
        <translation>Diese Ebene ist gedreht und kreuzt mehrere Dateien. Setzen Sie sie zurück (Ansicht → Schichten), oder klicken Sie in eine andere Ansicht.</translation>
    </message>
    <message>
        <source>The file of this slice cannot be read.</source>
        <translation>Die Datei dieser Schicht kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>Slice %1 of %2</source>
        <translation>Schicht %1 von %2</translation>
    </message>
    <message>
        <source>%1, at the crosshair</source>
        <translation>%1, am Fadenkreuz</translation>
    </message>
    <message>
        <source>1 item</source>
        <translation>1 Element</translation>
    </message>
    <message numerus="yes">
        <source>%n items</source>
        <translation>
            <numerusform>%n Element</numerusform>
            <numerusform>%n Elemente</numerusform>
        </translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>verborgen</translation>
    </message>
    <message>
        <source>Item %1</source>
        <translation>Element %1</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::TolerancePlot</name>
    <message>
        <source>%1 ml</source>
        <translation>%L1 ml</translation>
    </message>
    <message>
        <source>The region&apos;s volume against its tolerance, both logarithmic. A cliff is a leak; green marks where the region hardly changes</source>
        <translation>Volumen der Region gegen ihre Toleranz, beide logarithmisch. Eine Klippe ist ein Auslaufen; Grün zeigt, wo sich die Region kaum ändert</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::Tour</name>
    <message>
        <source>End the tour</source>
        <translation>Tour beenden</translation>
    </message>
    <message>
        <source>One body, five views</source>
        <translation>Ein Körper, fünf Ansichten</translation>
    </message>
    <message>
        <source>Above are two 3-D views, C1 and C2; below are three slices. The torso opens with several structures in focus: what hides them is cut away.</source>
        <translation>Oben sind zwei 3-D-Ansichten, C1 und C2; unten drei Schichten. Der Torso öffnet sich mit mehreren Strukturen im Fokus: was sie verdeckt, ist weggeschnitten.</translation>
    </message>
    <message>
        <source>Choose a structure</source>
        <translation>Eine Struktur wählen</translation>
    </message>
    <message>
        <source>A click on the left kidney in the axial slice makes it the focus. The cameras move to the two views that together see most of it.</source>
        <translation>Ein Klick auf die linke Niere in der axialen Schicht macht sie zum Fokus. Die Kameras gehen zu den zwei Ansichten, die zusammen am meisten von ihr sehen.</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Drehen</translation>
    </message>
    <message>
        <source>Drag with the left button in a 3-D view to turn it. The opening follows the kidney; C2 follows C1.</source>
        <translation>Ziehen mit der linken Taste dreht eine 3-D-Ansicht. Die Öffnung folgt der Niere; C2 folgt C1.</translation>
    </message>
    <message>
        <source>Widen the opening</source>
        <translation>Die Öffnung weiten</translation>
    </message>
    <message>
        <source>The slider Opening in the panel Cutaway sets how far the opening reaches beyond the focus.</source>
        <translation>Der Regler Öffnung im Panel Freischnitt legt fest, wie weit die Öffnung über den Fokus hinausreicht.</translation>
    </message>
    <message>
        <source>Bring tissue back</source>
        <translation>Gewebe zurückholen</translation>
    </message>
    <message>
        <source>The brush (P) paints back what the opening removed: here, tissue above the kidney. Ctrl+Z takes a stroke back.</source>
        <translation>Der Pinsel (P) malt zurück, was die Öffnung entfernt hat: hier Gewebe über der Niere. Strg+Z nimmt einen Strich zurück.</translation>
    </message>
    <message>
        <source>Keep it</source>
        <translation>Aufheben</translation>
    </message>
    <message>
        <source>Ctrl+S saves a session with all that you did; Ctrl+E saves a picture, for a slide. F1 opens the user guide.</source>
        <translation>Strg+S speichert eine Sitzung mit allem, was Sie getan haben; Strg+E speichert ein Bild, etwa für eine Folie. F1 öffnet das Benutzerhandbuch.</translation>
    </message>
    <message>
        <source>%1 of %2: %3</source>
        <translation>%1 von %2: %3</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::TransferFunctionEditor</name>
    <message>
        <source>Point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>Colour of the selected point</source>
        <translation>Farbe des gewählten Punkts</translation>
    </message>
    <message>
        <source>By value</source>
        <translation>Nach Wert</translation>
    </message>
    <message>
        <source>Open a transfer function</source>
        <translation>Transferfunktion öffnen</translation>
    </message>
    <message>
        <source>Transfer functions (*.json)</source>
        <translation>Transferfunktionen (*.json)</translation>
    </message>
    <message>
        <source>What the plot shows and edits</source>
        <translation>Was der Plot zeigt und bearbeitet</translation>
    </message>
    <message>
        <source>Drag points, or the edges, top and inside of a trapezoid. Double-click adds a point; Delete removes it; the wheel enlarges. The key ? lists all.</source>
        <translation>Ziehen Sie Punkte, oder Kanten, Oberseite und Inneres eines Trapezes. Doppelklick fügt einen Punkt hinzu; Entf löscht ihn; das Rad vergrößert. Die Taste ? listet alles.</translation>
    </message>
    <message>
        <source>Value of the selected point</source>
        <translation>Wert des gewählten Punkts</translation>
    </message>
    <message>
        <source>Opacity of 1 mm at the selected point</source>
        <translation>Deckkraft von 1 mm am gewählten Punkt</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Shows this part of the focus by a function of the values, as the context is shown, in place of one colour and opacity</source>
        <translation>Zeigt diesen Teil des Fokus durch eine Funktion der Werte, wie den Kontext, statt in einer Farbe und Deckkraft</translation>
    </message>
    <message>
        <source>From a preset</source>
        <translation>Aus einer Vorgabe</translation>
    </message>
    <message>
        <source>Takes the function of a preset for this part of the focus</source>
        <translation>Nimmt die Funktion einer Vorgabe für diesen Teil des Fokus</translation>
    </message>
    <message>
        <source>From a file…</source>
        <translation>Aus einer Datei…</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::TransferFunctionPlot</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Transfer function over the histogram</source>
        <translation>Transferfunktion über dem Histogramm</translation>
    </message>
    <message>
        <source>Colour…</source>
        <translation>Farbe…</translation>
    </message>
    <message>
        <source>Delete the point</source>
        <translation>Punkt löschen</translation>
    </message>
    <message>
        <source>Delete the trapezoid</source>
        <translation>Trapez löschen</translation>
    </message>
    <message>
        <source>Add a point</source>
        <translation>Punkt hinzufügen</translation>
    </message>
    <message>
        <source>Add a trapezoid</source>
        <translation>Trapez hinzufügen</translation>
    </message>
    <message>
        <source>By value</source>
        <translation>Nach Wert</translation>
    </message>
    <message>
        <source>Show all values</source>
        <translation>Alle Werte zeigen</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::Verification</name>
    <message>
        <source>Computed again in double precision: %1 pixels, drawn at random (seed %2). Beyond that: %3. Greatest difference: %4/255.</source>
        <translation>Mit doppelter Genauigkeit neu berechnet: %1 zufällig gezogene Pixel (Startwert %2). Darüber: %3. Größte Abweichung: %4/255.</translation>
    </message>
    <message>
        <source>%1 % of the pixels are within %2/255 of the exact picture: all were computed again.</source>
        <translation>%1 % der Pixel liegen innerhalb von %2/255 des exakten Bilds: alle wurden neu berechnet.</translation>
    </message>
    <message>
        <source>At least %1 % of the pixels are within %2/255 of the exact picture, with %3 % confidence.</source>
        <translation>Mindestens %1 % der Pixel liegen innerhalb von %2/255 des exakten Bilds, mit %3 % Konfidenz.</translation>
    </message>
    <message>
        <source>No 3-D view is on screen that could be verified.</source>
        <translation>Keine 3-D-Ansicht ist zu sehen, die geprüft werden könnte.</translation>
    </message>
    <message>
        <source>The picture is verified once it is drawn at full quality.</source>
        <translation>Das Bild wird geprüft, sobald es in voller Qualität gezeichnet ist.</translation>
    </message>
    <message>
        <source>Verify this picture</source>
        <translation>Dieses Bild prüfen</translation>
    </message>
    <message>
        <source>&amp;Save the picture…</source>
        <translation>&amp;Bild speichern…</translation>
    </message>
    <message>
        <source>Save the picture with its certificate</source>
        <translation>Bild mit seinem Zertifikat speichern</translation>
    </message>
    <message>
        <source>PNG</source>
        <translation>PNG</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>Wrote %1</source>
        <translation>%1 geschrieben</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::ViewArea</name>
    <message>
        <source>3-D views are not available here.

%1

The slices work without it.</source>
        <translation>3-D-Ansichten sind hier nicht verfügbar.

%1

Die Schichten funktionieren ohne sie.</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::ViewCommands</name>
    <message>
        <source>Standard view</source>
        <translation>Standardansicht</translation>
    </message>
    <message>
        <source>Reset view</source>
        <translation>Ansicht zurücksetzen</translation>
    </message>
    <message>
        <source>Reset views</source>
        <translation>Ansichten zurücksetzen</translation>
    </message>
    <message>
        <source>Freeze the opening</source>
        <translation>Öffnung einfrieren</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::VolumeView</name>
    <message>
        <source>The 3-D views cannot be drawn. %1</source>
        <translation>Die 3-D-Ansichten lassen sich nicht zeichnen. %1</translation>
    </message>
    <message>
        <source>The first 3-D picture of this study is being made…</source>
        <translation>Das erste 3-D-Bild dieser Studie entsteht…</translation>
    </message>
    <message>
        <source>Editing the label; the one before still shows</source>
        <translation>Das Label wird bearbeitet; noch ist das vorige zu sehen</translation>
    </message>
    <message>
        <source>Not yet as asked for: the picture is being prepared</source>
        <translation>Noch nicht das Verlangte: das Bild wird vorbereitet</translation>
    </message>
    <message>
        <source>Waits for the picture</source>
        <translation>Wartet auf das Bild</translation>
    </message>
    <message>
        <source>C%1</source>
        <translation>C%1</translation>
    </message>
    <message>
        <source>perspective</source>
        <translation>perspektivisch</translation>
    </message>
    <message>
        <source>parallel</source>
        <translation>parallel</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::WaitingBar</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Take back what the pictures do not show yet</source>
        <translation>Zurücknehmen, was die Bilder noch nicht zeigen</translation>
    </message>
    <message>
        <source>Preparing the picture, %1 s</source>
        <translation>Bild wird vorbereitet, %1 s</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::WelcomePage</name>
    <message>
        <source>3-D views are not available here; slices work. %1</source>
        <translation>3-D-Ansichten sind hier nicht verfügbar; Schichten funktionieren. %1</translation>
    </message>
    <message>
        <source>No graphics card was found: the processor draws the 3-D views, in smaller pictures while something moves. (%1)</source>
        <translation>Keine Grafikkarte gefunden: der Prozessor zeichnet die 3-D-Ansichten, in kleineren Bildern, während sich etwas bewegt. (%1)</translation>
    </message>
    <message>
        <source>The graphics card draws the 3-D views. (%1)</source>
        <translation>Die Grafikkarte zeichnet die 3-D-Ansichten. (%1)</translation>
    </message>
    <message>
        <source>Choose a structure in a CT or MR, and the tissue in front of it opens. &lt;b&gt;Not for diagnostic use.&lt;/b&gt;</source>
        <translation>Wählen Sie eine Struktur in einem CT oder MR, und das Gewebe davor öffnet sich. &lt;b&gt;Nicht für diagnostische Zwecke.&lt;/b&gt;</translation>
    </message>
    <message>
        <source>Opened last</source>
        <translation>Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>User guide (F1)</source>
        <translation>Benutzerhandbuch (F1)</translation>
    </message>
    <message>
        <source>Built-in phantoms</source>
        <translation>Eingebaute Phantome</translation>
    </message>
    <message>
        <source>Bodies made of simple shapes, with every structure labelled. Nobody&apos;s data: try everything on them.</source>
        <translation>Körper aus einfachen Formen, jede Struktur mit Label. Niemandes Daten: probieren Sie alles daran aus.</translation>
    </message>
    <message>
        <source>Guided tour</source>
        <translation>Geführte Tour</translation>
    </message>
    <message>
        <source>Clicks through the first minute on the torso phantom, and says at each step what it does.</source>
        <translation>Klickt sich durch die erste Minute am Torsophantom und sagt bei jedem Schritt, was geschieht.</translation>
    </message>
    <message>
        <source>Your own data</source>
        <translation>Eigene Daten</translation>
    </message>
    <message>
        <source>Drop a folder of DICOM files, or a NIfTI, NRRD or MetaImage file, anywhere in this window.</source>
        <translation>Ziehen Sie einen Ordner mit DICOM-Dateien, oder eine NIfTI-, NRRD- oder MetaImage-Datei, irgendwo in dieses Fenster.</translation>
    </message>
    <message>
        <source>Start the tour</source>
        <translation>Tour starten</translation>
    </message>
    <message>
        <source>Open a folder…</source>
        <translation>Ordner öffnen…</translation>
    </message>
    <message>
        <source>Open a file…</source>
        <translation>Datei öffnen…</translation>
    </message>
    <message>
        <source>session</source>
        <translation>Sitzung</translation>
    </message>
    <message>
        <source>study</source>
        <translation>Studie</translation>
    </message>
    <message>
        <source>%1 %2, name hidden</source>
        <translation>%1 %2, Name verborgen</translation>
    </message>
</context>
<context>
    <name>fenestra::viewer::WindowLevelDialog</name>
    <message>
        <source>Window and level</source>
        <translation>Fensterung</translation>
    </message>
    <message>
        <source>&amp;Invert: low values bright</source>
        <translation>&amp;Invertieren: niedrige Werte hell</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>&amp;Breite</translation>
    </message>
    <message>
        <source>&amp;Level</source>
        <translation>&amp;Zentrum</translation>
    </message>
</context>
</TS>
